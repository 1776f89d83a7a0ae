// Starts the page: pictures, tables, then the plots, which are drawn anew when filters, width or
// light and dark change.
const data = JSON.parse(document.getElementById('data').textContent);
const form = document.getElementById('filters');
let filters;

/// The plot of one scene, its points and the details beside them.
class ScenePlot {
  constructor(canvas) {
    this.canvas = canvas;
    this.part = data.parts.find((part) => part.id === canvas.dataset.part);
    this.figure = canvas.closest('figure');
    this.panel = this.figure.parentElement.querySelector('.details');
    this.selection = {
      cell: undefined, pinned: false,
      change: (cell, pinned) => {
        const other = cell !== this.selection.cell;
        Object.assign(this.selection, { cell, pinned });
        if (other) this.show();
      },
    };
  }

  visiblePoints() {
    const [kind] = filters.kind;
    return this.part.points[kind].filter(({ cell }) => {
      const { technique, backend } = data.cells[cell];
      return passes(filters, { technique, backend });
    });
  }

  show() {
    this.mark?.();
    const cell = data.cells[this.selection.cell];
    if (cell) showDetails(this.panel, cell);
  }

  async draw() {
    this.figure.hidden = this.panel.hidden = false;
    const points = this.visiblePoints();
    const focused = this.canvas.querySelector('.point:focus')?.dataset.cell;
    this.view?.finalize();
    this.mark = undefined;
    const width = Math.floor(this.canvas.clientWidth);
    if (!points.length || !width) {
      this.canvas.replaceChildren(element('p', { class: 'empty' }, 'No point is left by the filters.'));
      this.panel.replaceChildren();
      this.selection.cell = undefined;
      return;
    }
    const [kind] = filters.kind;
    const rows = plotRows(points, data.cells);
    const shapes = Object.fromEntries(Object.values(data.cells).map((c) => [c.backend, c.shape]));
    const drawing = element('div', { 'aria-hidden': 'true' });
    this.canvas.replaceChildren(drawing);
    this.view = await drawPlot(drawing, {
      rows, fronts: frontRows(this.part.fronts[kind], rows, shapes), width,
      height: width < 500 ? 360 : 460, timeTitle: `${this.part.timeName}, ms`,
      errorTitle: `${kind === 'image' ? 'Image' : 'Visibility'} RMSE`,
    });
    this.mark = layPoints(this.canvas, this.view, rows, data.cells, this.selection);
    if (!rows.some((row) => row.cell === this.selection.cell)) this.selectFirst(rows);
    this.show();
    if (focused) this.canvas.querySelector(`.point[data-cell="${focused}"]`)?.focus();
  }

  /// Something to look at from the start: the middle of the front.
  selectFirst(rows) {
    const front = rows.filter((row) => row.state !== 'off').sort((a, b) => a.time - b.time);
    const from = front.length ? front : rows;
    Object.assign(this.selection, { cell: from[from.length >> 1].cell, pinned: false });
  }
}

function start() {
  document.documentElement.classList.add('scripted');
  collectPictures();
  openLargeOnPress(data.cells);
  document.querySelectorAll('table.sortable').forEach(makeSortable);
  form.hidden = false;
  filters = applyFilters(form);
  const plots = [
    ...[...document.querySelectorAll('.lines')].map((canvas) => new LinePlot(canvas)),
    ...[...document.querySelectorAll('.canvas')].map((canvas) => new ScenePlot(canvas))];
  // One after the other: a plot that is still being drawn is not drawn over.
  let turn = Promise.resolve();
  let waiting = false;
  const drawAll = () => {
    if (waiting) return;
    waiting = true;
    turn = turn.then(async () => {
      waiting = false;
      for (const plot of plots) if (!plot.canvas.closest('section[hidden]')) await plot.draw();
      document.documentElement.dataset.drawn = String(Number(document.documentElement.dataset.drawn || 0) + 1);
    });
  };
  const refilter = () => {
    filters = applyFilters(form);
    drawAll();
  };
  form.addEventListener('change', refilter);
  form.addEventListener('reset', () => setTimeout(refilter));
  form.addEventListener('submit', (event) => event.preventDefault());
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawAll);
  let width = innerWidth;
  addEventListener('resize', () => {
    if (innerWidth === width) return;  // phones change the height while scrolling
    width = innerWidth;
    drawAll();
  });
  drawAll();
}

start();
