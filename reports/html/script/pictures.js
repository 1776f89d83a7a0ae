// Pictures: each file stands once in the page; other places get it from there. A viewer flips
// between a cell's pictures in one place, which is how small differences are seen.
const kRoles = [['image', 'Image'], ['truth', 'Truth'], ['error', 'Error'], ['blame', 'Blame']];
const sources = new Map();

function collectPictures() {
  const images = [...document.querySelectorAll('img[data-picture]')];
  for (const image of images) if (image.src) sources.set(image.dataset.picture, image.src);
  for (const image of images)
    if (!image.src && sources.has(image.dataset.picture)) image.src = sources.get(image.dataset.picture);
}

/// Buttons for the roles that the cell has, and the picture of the chosen one.
function pictureViewer(cell, role = 'image') {
  const roles = kRoles.filter(([name]) => sources.has(cell.pictures[name]));
  if (!roles.length) return element('p', { class: 'no-picture' }, 'no picture');
  const image = element('img', { width: cell.width, height: cell.height, alt: '' });
  const choose = (name) => {
    image.src = sources.get(cell.pictures[name]);
    image.alt = `${name} of ${cell.name}`;
    for (const button of buttons.children)
      button.setAttribute('aria-pressed', String(button.dataset.role === name));
  };
  const buttons = element('div', { class: 'roles', role: 'group', 'aria-label': 'Picture' },
    ...roles.map(([name, title]) => element('button', {
      type: 'button', 'data-role': name, onclick: () => choose(name) }, title)));
  choose(roles.some(([name]) => name === role) ? role : roles[0][0]);
  return element('div', { class: 'picture-viewer' }, image, buttons);
}

/// A picture of the gallery opens large when pressed.
function openLargeOnPress(cells) {
  const dialog = document.getElementById('zoom');
  for (const image of document.querySelectorAll('.gallery img')) {
    const cell = cells[image.closest('[data-cell]')?.dataset.cell];
    if (!cell) continue;
    const role = kRoles.find(([name]) => cell.pictures[name] === image.dataset.picture)?.[0];
    const button = element('button', { type: 'button', class: 'zoom', 'aria-haspopup': 'dialog' });
    image.replaceWith(button);
    button.append(image);
    button.addEventListener('click', () => {
      dialog.querySelector('.viewer').replaceChildren(
        element('h2', {}, cell.name), pictureViewer(cell, role));
      dialog.showModal();
    });
  }
}
