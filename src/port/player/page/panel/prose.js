// Descriptions from ShaderToy: entities and tags such as [b] and [url] are rendered; only https: URLs become
// links.

/** Decodes entities such as `&lt;`. @param {string} text */
function decodeEntities(text) {
  return text.replace(/&(?:#\d{1,7}|#x[\da-f]{1,6}|[a-z][a-z\d]{1,30});/gi, (entity) => {
    const parsed = new DOMParser().parseFromString(entity, 'text/html');
    return parsed.body.textContent || entity;
  });
}

/** HTML elements for the tags of ShaderToy. @type {Record<string, string>} */
const PROSE_TAGS = { b: 'strong', i: 'em', u: 'u', code: 'code', quote: 'q' };

/**
 * The description as nodes.
 * @param {string} source
 * @returns {DocumentFragment}
 */
function prose(source) {
  const text = decodeEntities(source);
  const whole = document.createDocumentFragment();
  /** @type {{tag: string, node: Node}[]} */
  const open = [{ tag: '', node: whole }];
  const tags = /\[(url|img|video)(?:=([^\]\s]+))?\]([\s\S]*?)\[\/\1\]|\[(\/?)(b|i|u|code|quote)\]|https:\/\/[^\s<>"\][]*[^\s<>"\][.,;:!?)'*]/gi;
  let from = 0;
  for (const match of text.matchAll(tags)) {
    const inner = open[open.length - 1];
    const [all, kind, address, words, slash, mark] = match;
    inner.node.appendChild(document.createTextNode(text.slice(from, match.index)));
    from = match.index + all.length;
    const tag = mark?.toLowerCase();
    if (kind) inner.node.appendChild(makeLink((address ?? words).trim(), words.trim() || address));
    else if (!mark) inner.node.appendChild(makeLink(all, all));
    else if (!slash) {
      const node = document.createElement(PROSE_TAGS[tag]);
      inner.node.appendChild(node);
      open.push({ tag, node });
    } else if (inner.tag === tag) open.pop();
    // An unmatched end tag is shown as text.
    else inner.node.appendChild(document.createTextNode(all));
  }
  open[open.length - 1].node.appendChild(document.createTextNode(text.slice(from)));
  return whole;
}

/** Shows title, author, licence and description. @param {ProjectData} project */
function showAbout(project) {
  const title = decodeEntities(project.title);
  document.title = title || 'shader';
  element('title', HTMLElement).textContent = title || 'Shader';
  element('author', HTMLElement).textContent = project.author ? `by ${project.author}` : '';
  element('canvas', HTMLCanvasElement).setAttribute('aria-label', title ? `Shader: ${title}` : 'Shader');
  element('license', HTMLElement).textContent = project.license;
  element('description', HTMLElement).replaceChildren(prose(project.description));
  if (/^https:/.test(project.link)) element('origin', HTMLElement).replaceChildren(makeLink(project.link, project.link));
}
