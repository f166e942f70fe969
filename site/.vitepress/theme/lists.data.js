// The lists of rules and compile errors for the components, read when the site is built.
import { allErrors, allRules } from '../pages.js';

/** A summary has no other marks than those of code. */
function html(summary) {
  const escaped = summary.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
  return escaped.replace(/`([^`]+)`/g, '<code>$1</code>');
}

const rendered = (entry) => ({ ...entry, html: html(entry.summary) });

export default {
  watch: ['../../../rules/README.md'],
  load: () => ({ rules: allRules().map(rendered), errors: allErrors().map(rendered) }),
};
