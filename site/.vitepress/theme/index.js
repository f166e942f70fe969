// VitePress's theme without its web font, which would be most of a page.
import { useRoute } from 'vitepress';
import DefaultTheme from 'vitepress/theme-without-fonts';
import { nextTick, onMounted, watch } from 'vue';
import './style.css';
import './examples.css';

/** The theme makes buttons of headings that do nothing, and buttons inside buttons. */
function repairButtons() {
  const inert = '.VPSidebarItem:not(.collapsible) > .item[role="button"], .VPSidebarItem .item[role="button"] > .caret';
  for (const element of document.querySelectorAll(inert)) {
    element.removeAttribute('role');
    element.removeAttribute('tabindex');
    element.removeAttribute('aria-label');
  }
}

/** The sidebars are long: shows the entry of the page. */
function showEntry() {
  const entry = document.querySelector('.VPSidebarItem.is-link.is-active > .item')?.getBoundingClientRect();
  const sidebar = document.querySelector('.VPSidebar');
  if (entry && (entry.bottom > innerHeight || entry.top < 0)) sidebar.scrollTop += entry.top - innerHeight / 2;
}

async function repairSidebar() {
  await nextTick();
  repairButtons();
  showEntry();
}

export default {
  extends: DefaultTheme,
  setup() {
    const route = useRoute();
    onMounted(repairSidebar);
    watch(() => route.path, repairSidebar);
  },
};
