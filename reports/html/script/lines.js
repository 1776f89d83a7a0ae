// Plots of lines: what was found over a parameter, or time over the size of a scene. Where values
// span magnitudes the axis is logarithmic down to the least of them and linear from there to 0.
const kWidths = [2, 3.5, 1.25, 5];

function lineRows(lines) {
  const labels = [...new Set(lines.map((l) => l.label))];
  return lines.flatMap((l, i) => l.points.map(([x, y]) => ({
    line: i, x, y, color: color(l.color), shape: kShapes[l.shape], dash: kDashes[l.shape] || [],
    width: kWidths[labels.indexOf(l.label) % kWidths.length], broken: l.breaksAt === x })));
}

/// Equal limits of several lines stand once.
function limitRows(lines) {
  const seen = new Set();
  return lines.flatMap((l, i) => {
    const key = JSON.stringify(l.limit);
    if (seen.has(key)) return [];
    seen.add(key);
    return l.limit.map(([x, y]) => ({ line: i, x, y }));
  });
}

/// The end of each line that has a label, where they are too close one below the other.
function labelRows(lines, toY, high) {
  const rows = lines.filter((l) => l.label && l.points.length).map((l) => {
    const [x, y] = l.points[l.points.length - 1];
    return { x, y, text: l.label, color: color(l.color), at: toY(y) };
  }).sort((a, b) => a.at - b.at);
  const kApart = 14;
  rows.forEach((row, i) => {
    if (i) row.at = Math.max(row.at, rows[i - 1].at + kApart);
  });
  for (let i = rows.length - 1; i >= 0; --i)
    rows[i].at = Math.min(rows[i].at, i + 1 < rows.length ? rows[i + 1].at - kApart : high);
  return rows;
}

function valueScale(curve, values) {
  const most = Math.max(...values, 0);
  const least = Math.min(...values, 0);
  const sizes = values.filter((v) => v !== 0).map(Math.abs);
  const domain = [least, most || 1];
  if (!curve.wideY || !sizes.length) return { type: 'linear', domain, nice: true };
  return { type: 'symlog', domain: [domain[0], domain[1] * 1.3], constant: Math.min(...sizes) };
}

/// 0 and powers of ten, no closer than labels can stand.
function wideTicks({ constant, domain }, height) {
  const first = Math.floor(Math.log10(constant));
  const decades = Math.floor(Math.log10(domain[1])) - first + 1;
  const step = Math.max(1, Math.ceil(decades / (height / 30)));
  const out = [0];
  for (let e = first + step; Number(`1e${e}`) <= domain[1]; e += step) out.push(Number(`1e${e}`));
  return out;
}

function lineAxis(orient, title, extra) {
  return {
    orient, scale: orient === 'bottom' ? 'x' : 'y', title, grid: true, labelOverlap: true,
    gridColor: color('line'), domainColor: color('line'), tickColor: color('line'),
    labelColor: color('ink'), titleColor: color('ink'), labelFontSize: 12, titleFontSize: 12,
    titleFontWeight: 'normal', titlePadding: 6, titleLimit: 300, ...extra,
  };
}

function lineMarks() {
  const place = { x: { scale: 'x', field: 'x' }, y: { scale: 'y', field: 'y' } };
  const facet = (name, data, encode) => ({
    type: 'group', interactive: false, from: { facet: { name, data, groupby: 'line' } },
    marks: [{ type: 'line', from: { data: name }, interactive: false,
      encode: { update: { ...place, ...encode } } }],
  });
  return [
    facet('allowed', 'limits', {
      stroke: { value: color('quiet') }, strokeWidth: { value: 1.5 }, strokeDash: { value: [2, 4] } }),
    facet('found', 'rows', {
      stroke: { field: 'color' }, strokeWidth: { field: 'width' }, strokeDash: { field: 'dash' } }),
    { type: 'symbol', name: 'found-points', from: { data: 'rows' }, interactive: false,
      encode: { update: {
        ...place, shape: { field: 'shape' }, size: { value: 36 }, fill: { field: 'color' } } } },
    { type: 'symbol', name: 'breaks', from: { data: 'broken' }, interactive: false,
      encode: { update: {
        ...place, shape: { value: 'M-1,-1L1,1M-1,1L1,-1' }, size: { value: 190 },
        stroke: { value: color('serious') }, strokeWidth: { value: 2.5 } } } },
    { type: 'text', from: { data: 'labels' }, interactive: false,
      encode: { update: {
        x: { signal: 'width + 6' }, y: { field: 'at' }, text: { field: 'text' },
        fill: { field: 'color' }, baseline: { value: 'middle' }, fontSize: { value: 12 } } } },
  ];
}

/// Draws the lines of a curve into `container`; gives the view once it stands.
async function drawLines(container, curve, lines, width, height) {
  const rows = lineRows(lines);
  const limits = limitRows(lines);
  const xs = [...rows, ...limits].map((r) => r.x);
  const values = valueScale(curve, [...rows, ...limits].map((r) => r.y));
  const logX = curve.logX && Math.min(...xs) > 0;
  const font = getComputedStyle(document.body).fontFamily;
  const spec = {
    width, height, padding: 4, autosize: { type: 'fit', contains: 'padding' },
    config: { text: { font }, axis: { labelFont: font, titleFont: font } },
    data: [
      { name: 'rows', values: rows }, { name: 'limits', values: limits },
      { name: 'broken', values: rows.filter((r) => r.broken) },
      { name: 'labels', values: labelRows(lines, () => 0, height) },
    ],
    scales: [
      { name: 'x', type: logX ? 'log' : 'linear', range: 'width', nice: false, zero: false,
        domain: [Math.min(...xs), Math.max(...xs)] },
      { name: 'y', ...values, range: 'height', zero: true },
    ],
    axes: [
      lineAxis('bottom', curve.xTitle, logX
        ? tickLabels(decadeTicks(xs)) : { tickCount: Math.floor(width / 70) }),
      lineAxis('left', curve.yTitle, values.constant
        ? tickLabels(wideTicks(values, height)) : { tickCount: 5 }),
    ],
    marks: lineMarks(),
  };
  const runtime = vegaLibrary('vega-parser').parse(spec, {}, { ast: true });
  const { expressionInterpreter } = vegaLibrary('vega-interpreter');
  const view = new (vegaLibrary('vega-view').View)(
    runtime, { expr: expressionInterpreter, renderer: 'svg', container, hover: false });
  await view.runAsync();
  if (lines.some((l) => l.label)) {
    // Only now the scale is known.
    const y = view.scale('y');
    const placed = labelRows(lines, (v) => y(v), view.signal('height'));
    await view.change('labels', vegaLibrary('vega-dataflow').changeset()
      .remove(() => true).insert(placed)).runAsync();
  }
  return view;
}

/// Powers of ten over a range, at most eight.
function decadeTicks(xs) {
  const first = Math.ceil(Math.log10(Math.min(...xs)));
  const last = Math.floor(Math.log10(Math.max(...xs)));
  if (last - first < 2) return tickValues([Math.min(...xs), Math.max(...xs)]);
  const step = Math.ceil((last - first + 1) / 6);
  const out = [];
  for (let e = first; e <= last; e += step) out.push(Number(`1e${e}`));
  return out;
}

/// Powers of ten where numbers would be all zeros.
function tickLabels(ticks) {
  const long = ticks.some((t) => t >= 1e6 || (t > 0 && t < 1e-4));
  const text = { signal: "datum.value === 0 ? '0' : datum.label" };
  return { values: ticks, format: long ? '~e' : '~g', encode: { labels: { update: { text } } } };
}

/// One such plot in the page.
class LinePlot {
  constructor(canvas) {
    this.canvas = canvas;
    this.curve = data.curves[Number(canvas.dataset.curve)];
  }

  async draw() {
    this.view?.finalize();
    const lines = this.curve.lines.filter(
      ({ technique, backend, points }) => points.length && passes(filters, { technique, backend }));
    const width = Math.floor(this.canvas.clientWidth);
    if (!lines.length || !width) {
      this.view = undefined;
      this.canvas.replaceChildren(element('p', { class: 'empty' }, 'No line is left by the filters.'));
      return;
    }
    const drawing = element('div', { 'aria-hidden': 'true' });
    this.canvas.replaceChildren(drawing);
    this.view = await drawLines(drawing, this.curve, lines, width, 240);
  }
}
