// The plot of error over time: both axes logarithmic, one colour a technique, one shape a backend,
// intervals on both axes, the Pareto front of each backend as a staircase. An error of zero has no
// place on a logarithm: such points stand in a band of their own at the bottom.
const kBand = 40;

Object.assign(vegaLibrary('vega-dataflow').transforms, vegaLibrary('vega-transforms'),
  vegaLibrary('vega-view-transforms'), vegaLibrary('vega-encode'));

/// 1-2-5 steps where the range is short, powers of ten where it is long.
function tickValues([low, high]) {
  const decades = Math.log10(high / low);
  const steps = decades < 1.2 ? [1, 1.5, 2, 3, 5, 7] : decades < 3 ? [1, 2, 5] : [1];
  const out = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); ++e)
    for (const s of steps) {
      const value = Number(`${s}e${e}`);
      if (value >= low && value <= high) out.push(value);
    }
  return out;
}

function padded(values, factor) {
  const positive = values.filter((v) => v > 0);
  if (!positive.length) return [1e-3, 1];
  return [Math.min(...positive) / factor, Math.max(...positive) * factor];
}

/// One row a point, everything that the marks need.
function plotRows(points, cells) {
  const errors = padded(points.flatMap((p) => p.error), 1.35);
  return points.map((p) => {
    const cell = cells[p.cell];
    const [time, fast, slow] = p.time;
    const [error, least, most] = p.error;
    return {
      cell: p.cell, time, fast, slow, error, zero: !(error > 0),
      least: Math.max(least, errors[0]), most: Math.max(most, errors[0]),
      color: color(cell.color), shape: kShapes[cell.shape],
      state: p.uncertain ? 'uncertain' : p.front ? 'front' : 'off',
    };
  });
}

function frontRows(fronts, rows, backends) {
  const byCell = new Map(rows.map((r) => [r.cell, r]));
  return fronts.flatMap(({ backend, cells }) =>
    cells.filter((c) => byCell.has(c)).map((c) => (
      { ...byCell.get(c), backend, dash: kDashes[backends[backend]] || [] })));
}

const kPosition = {
  x: { scale: 'x', field: 'time' },
  y: [{ test: 'datum.zero', signal: 'zero' }, { scale: 'y', field: 'error' }],
};

function frontMarks() {
  return {
    type: 'group', interactive: false,
    from: { facet: { name: 'front', data: 'fronts', groupby: 'backend' } },
    marks: [{
      type: 'line', from: { data: 'front' }, interactive: false,
      encode: { update: {
        ...kPosition, interpolate: { value: 'step-after' }, stroke: { value: color('front') },
        strokeWidth: { value: 1.5 }, strokeDash: { field: 'dash' } } },
    }],
  };
}

function intervalMarks() {
  const style = { stroke: { field: 'color' }, strokeWidth: { value: 1.25 }, opacity: { value: 0.75 } };
  return [{
    type: 'rule', name: 'time-interval', from: { data: 'rows' }, interactive: false,
    encode: { update: {
      x: { scale: 'x', field: 'fast' }, x2: { scale: 'x', field: 'slow' }, y: kPosition.y, ...style } },
  }, {
    type: 'rule', name: 'error-interval', from: { data: 'rows' }, interactive: false,
    encode: { update: {
      x: kPosition.x,
      y: [{ test: 'datum.zero', signal: 'zero' }, { scale: 'y', field: 'least' }],
      y2: [{ test: 'datum.zero', signal: 'zero' }, { scale: 'y', field: 'most' }], ...style } },
  }];
}

function pointMarks(width) {
  return {
    type: 'symbol', name: 'points', from: { data: 'rows' }, interactive: false,
    encode: { update: {
      ...kPosition, shape: { field: 'shape' }, size: { value: width < 500 ? 64 : 110 },
      fill: [{ test: "datum.state === 'uncertain'", value: color('paper') }, { field: 'color' }],
      fillOpacity: [{ test: "datum.state === 'off'", value: 0.35 }, { value: 1 }],
      stroke: { field: 'color' },
      strokeWidth: [{ test: "datum.state === 'uncertain'", value: 2.5 }, { value: 1.25 }] } },
  };
}

function bandMarks() {
  return [{
    type: 'rect', interactive: false,
    encode: { update: {
      x: { value: 0 }, x2: { signal: 'width' }, y: { signal: `zero - ${kBand / 2 - 4}` },
      y2: { signal: 'height' }, fill: { value: color('band') } } },
  }, {
    type: 'text', name: 'zero-label', interactive: false,
    encode: { update: {
      x: { value: -9 }, y: { signal: 'zero' }, text: { value: '0' }, align: { value: 'right' },
      baseline: { value: 'middle' }, fill: { value: color('ink') }, fontSize: { value: 12 } } },
  }, {
    type: 'text', interactive: false,
    encode: { update: {
      x: { value: 8 }, y: { signal: 'zero' }, text: { value: 'no error' },
      align: { value: 'left' }, baseline: { value: 'middle' }, fill: { value: color('quiet') },
      fontSize: { value: 12 } } },
  }];
}

function axis(orient, scale, domain, title) {
  return {
    orient, scale, title, values: tickValues(domain), format: '~g', grid: true,
    gridColor: color('line'), domainColor: color('line'), tickColor: color('line'),
    labelColor: color('ink'), titleColor: color('ink'), labelFontSize: 12, titleFontSize: 13,
    titleFontWeight: 'normal', labelOverlap: true, titlePadding: 8,
  };
}

/// Draws into `container`; gives the view once it stands.
async function drawPlot(container, { rows, fronts, width, height, timeTitle, errorTitle }) {
  const x = padded(rows.flatMap((r) => [r.fast, r.time, r.slow]), 1.2);
  const y = padded(rows.flatMap((r) => (r.zero ? [] : [r.least, r.error, r.most])), 1.35);
  const band = rows.some((r) => r.zero) ? kBand : 0;
  const font = getComputedStyle(document.body).fontFamily;
  const spec = {
    width, height, padding: 4, autosize: { type: 'fit', contains: 'padding' },
    config: { text: { font }, axis: { labelFont: font, titleFont: font } },
    signals: [{ name: 'zero', update: `height - ${kBand / 2 - 2}` }],
    data: [{ name: 'rows', values: rows }, { name: 'fronts', values: fronts }],
    scales: [
      { name: 'x', type: 'log', domain: x, range: 'width', nice: false },
      { name: 'y', type: 'log', domain: y, range: [{ signal: `height - ${band}` }, 0], nice: false },
    ],
    axes: [axis('bottom', 'x', x, timeTitle), axis('left', 'y', y, errorTitle)],
    marks: [...(band ? bandMarks() : []), frontMarks(), ...intervalMarks(), pointMarks(width)],
  };
  // The interpreter instead of generated code: the page's policy allows no eval.
  const runtime = vegaLibrary('vega-parser').parse(spec, {}, { ast: true });
  const { expressionInterpreter } = vegaLibrary('vega-interpreter');
  const view = new (vegaLibrary('vega-view').View)(
    runtime, { expr: expressionInterpreter, renderer: 'svg', container, hover: false });
  await view.runAsync();
  return view;
}
