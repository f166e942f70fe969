// Shows images of values, with a mark on the debugged pixel. A click debugs another one.
'use strict';

const vscode = acquireVsCodeApi();
const images = document.getElementById('images');

function element(name, className, text = '') {
    const made = document.createElement(name);
    made.className = className;
    made.textContent = text;
    return made;
}

/** The head of an image: expression, colour, value. */
function head({ expression, value, color }) {
    const made = element('header', '');
    made.append(element('code', 'expression', expression));
    if (color) {
        const box = element('span', 'color');
        box.style.backgroundColor = color;
        box.title = color;
        made.append(box);
    }
    if (value !== undefined) made.append(element('code', 'value', value));
    const close = element('button', '', '×');
    close.title = `Remove ${expression}`;
    close.addEventListener('click', () => vscode.postMessage({ type: 'remove', expression }));
    made.append(close);
    return made;
}

/** An image; its pixels are counted from the lower left corner. It may have a legend below. */
function screen({ expression, png, width, height, rows, pixel }) {
    const legend = height - rows;
    const made = element('div', 'screen');
    const image = element('img', '');
    image.src = `data:image/png;base64,${png}`;
    image.alt = `${expression} over the screen`;
    const mark = element('div', 'mark');
    const [x, y] = pixel;
    Object.assign(mark.style, {
        left: `${100 * x / width}%`, bottom: `${100 * (legend + y) / height}%`, width: `${100 / width}%`, height: `${100 / height}%`,
    });
    const under = (event) => {
        const box = image.getBoundingClientRect();
        const column = Math.floor((event.clientX - box.left) / box.width * width);
        const row = Math.floor((box.bottom - event.clientY) / box.height * height) - legend;
        return [Math.min(Math.max(column, 0), width - 1), Math.min(Math.max(row, 0), rows - 1)];
    };
    image.addEventListener('mousemove', (event) => {
        image.title = `Debug pixel ${under(event).join(', ')}`;
    });
    image.addEventListener('click', (event) => vscode.postMessage({ type: 'pixel', pixel: under(event) }));
    made.append(image, mark);
    return made;
}

function figure(shown) {
    const made = element('section', '');
    made.append(head(shown));
    if (shown.error) {
        made.append(element('p', 'error', shown.error));
        return made;
    }
    const { width, rows, pixels, pixel } = shown;
    const all = width * rows;
    const count = pixels === all ? 'all pixels' : `${pixels.toLocaleString('en')} of ${all.toLocaleString('en')} pixels`;
    made.append(screen(shown), element('p', '', `${width} × ${rows}; ${count} have a value; pixel ${pixel.join(', ')}`));
    return made;
}

window.addEventListener('message', ({ data }) => {
    if (data.type !== 'images') return;
    images.replaceChildren(...data.images.map(figure));
    if (data.images.length === 0) images.append(element('p', '', 'No values. Choose “Show Value over the Screen” on a variable.'));
});
vscode.postMessage({ type: 'ready' });
