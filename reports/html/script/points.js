// Reaching the points of a plot: the pointer takes the nearest, a tap or click keeps it, and one
// button a point, at its place, serves the keyboard: arrows go along time and error.
const kReach = 28;

function placesOf(view, rows) {
  const [left, top] = view.origin().map((v) => v + view.padding().left);
  const x = view.scale('x');
  const y = view.scale('y');
  const zero = view.signal('zero');
  return rows.map((row) => (
    { row, x: left + x(row.time), y: top + (row.zero ? zero : y(row.error)) }));
}

function nearest(places, x, y) {
  let best = null;
  let least = kReach;
  for (const place of places) {
    const distance = Math.hypot(place.x - x, place.y - y);
    if (distance <= least) {
      least = distance;
      best = place;
    }
  }
  return best;
}

/// The next place for a key, or undefined for keys that are none of ours.
function step(places, current, key) {
  const along = (by) => [...places].sort((a, b) => by(a) - by(b));
  const move = (order, by) =>
    order[Math.min(Math.max(order.indexOf(current) + by, 0), order.length - 1)];
  const byTime = along((p) => p.x);
  const byError = along((p) => -p.y);
  return {
    ArrowRight: () => move(byTime, 1), ArrowLeft: () => move(byTime, -1),
    ArrowUp: () => move(byError, 1), ArrowDown: () => move(byError, -1),
    Home: () => byTime[0], End: () => byTime[byTime.length - 1],
  }[key]?.();
}

/// Lays the buttons over the plot. `selection` is {cell, pinned, change(cell, pinned)}.
function layPoints(canvas, view, rows, cells, selection) {
  const places = placesOf(view, rows);
  const layer = element('div', { class: 'points-layer', role: 'group', 'aria-label': 'Points' });
  for (const place of places) {
    const cell = cells[place.row.cell];
    place.button = element('button', {
      type: 'button', class: 'point', 'data-cell': place.row.cell, tabindex: '-1',
      'aria-label': [cell.technique, cell.backend, cell.variant,
        ...cell.figures.slice(0, 3).map(([label, text]) => `${label} ${text}`)].filter(Boolean).join(', '),
      onfocus: () => selection.change(place.row.cell, true),
      onblur: () => selection.change(selection.cell, false),
      onkeydown: (event) => {
        const next = step(places, place, event.key);
        if (!next) return;
        event.preventDefault();
        next.button.focus();
      },
    });
    place.button.style.left = `${place.x}px`;
    place.button.style.top = `${place.y}px`;
    layer.append(place.button);
  }
  canvas.append(layer);

  const under = (event) => {
    const box = canvas.getBoundingClientRect();
    return nearest(places, event.clientX - box.left, event.clientY - box.top);
  };
  layer.addEventListener('pointermove', (event) => {
    const place = under(event);
    layer.classList.toggle('over', Boolean(place));
    if (place && !selection.pinned && event.pointerType !== 'touch')
      selection.change(place.row.cell, false);
  });
  layer.addEventListener('click', (event) => {
    // A button that the keyboard pressed has no place of the pointer.
    if (event.detail === 0) return;
    const place = under(event);
    if (place) selection.change(place.row.cell, true);
    else selection.change(selection.cell, false);
  });

  return () => {
    const shown = places.find((p) => p.row.cell === selection.cell) || places[0];
    for (const { button } of places) {
      button.tabIndex = button === shown?.button ? 0 : -1;
      button.classList.toggle('selected', button === shown?.button);
      if (button === shown?.button) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
    }
  };
}
