// Tables sort by a press on a column's header: ascending, then descending. What is absent goes last
// either way.
function valueOf(row, column) {
  const cell = row.cells[column];
  if (cell.dataset.value !== undefined) return Number(cell.dataset.value);
  const text = cell.textContent.trim();
  return text === '' || text.startsWith('–') ? null : text;
}

function compare(a, b) {
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  return String(a).localeCompare(String(b), 'en', { numeric: true });
}

function sortTable(table, column, ascending) {
  const body = table.tBodies[0];
  const keyed = [...body.rows].map((row) => ({ row, value: valueOf(row, column) }));
  keyed.sort((a, b) => {
    if (a.value === null || b.value === null) return (a.value === null) - (b.value === null);
    return ascending ? compare(a.value, b.value) : compare(b.value, a.value);
  });
  body.append(...keyed.map(({ row }) => row));
  [...table.tHead.rows[0].cells].forEach((header, i) =>
    header.setAttribute('aria-sort', i !== column ? 'none' : ascending ? 'ascending' : 'descending'));
}

function makeSortable(table) {
  [...table.tHead.rows[0].cells].forEach((header, column) => {
    const button = element('button', {
      type: 'button',
      onclick: () => sortTable(table, column, header.getAttribute('aria-sort') !== 'ascending'),
    }, ...header.childNodes);
    header.append(button);
    header.setAttribute('aria-sort', 'none');
  });
}
