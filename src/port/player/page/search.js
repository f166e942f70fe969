// The search of a gallery. It is hidden without scripts.

function searchGallery() {
  const box = /** @type {HTMLInputElement} */ (document.querySelector('#search'));
  const none = /** @type {HTMLElement} */ (document.querySelector('#none'));
  const cards = [...document.querySelectorAll('li')];
  const texts = cards.map((card) => (card.textContent ?? '').toLowerCase());
  const show = () => {
    const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
    cards.forEach((card, i) => {
      card.hidden = !words.every((word) => texts[i].includes(word));
    });
    none.hidden = cards.some((card) => !card.hidden);
  };
  box.addEventListener('input', show);
  box.hidden = cards.length < 2;
  show();
}

searchGallery();
