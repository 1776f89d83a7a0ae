// Beside a plot: the chosen cell's picture, figures and the command that reproduces it.

/// Copies, and says whether it did. Pages from disk may lack the clipboard's interface.
async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = element('textarea', { class: 'unseen', 'aria-hidden': 'true' });
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}

function commandWithCopy(command) {
  const code = element('code', {}, command);
  const said = element('output', { class: 'said', 'aria-live': 'polite' });
  const button = element('button', {
    type: 'button', class: 'copy',
    onclick: async () => {
      if (await copyText(command)) {
        said.value = 'copied';
        return;
      }
      getSelection().selectAllChildren(code);
      said.value = 'selected: press Ctrl+C';
    },
  }, 'Copy');
  return element('div', { class: 'command' }, code, element('p', {}, button, ' ', said));
}

function showDetails(panel, cell) {
  // Who looks at error maps goes on to look at error maps.
  const role = panel.querySelector('.roles [aria-pressed=true]')?.dataset.role;
  const figures = element('dl');
  for (const [label, text] of cell.figures)
    figures.append(element('div', {}, element('dt', {}, label), element('dd', {}, text)));
  const title = element('h4', {},
    element('span', { class: `technique ${cell.color}` }, cell.technique), ' ',
    element('span', { class: `backend ${cell.shape}` }, cell.backend));
  if (cell.variant) title.append(' ', element('small', {}, cell.variant));
  panel.replaceChildren(title, pictureViewer(cell, role), figures, commandWithCopy(cell.command));
  panel.dataset.cell = cell.name;
}
