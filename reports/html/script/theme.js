// What a technique and a backend look like. Colours are custom properties of the style sheet, so that
// plots follow light and dark; shapes are those of the glyphs before a backend's name.
const kShapes = { b0: 'circle', b1: 'square', b2: 'triangle-up', b3: 'diamond', b4: 'cross' };
const kDashes = { b0: [], b1: [6, 4], b2: [2, 3], b3: [8, 3, 2, 3], b4: [1, 4] };

function color(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/// An element with attributes and children; texts are texts, never markup.
function element(tag, attributes = {}, ...children) {
  const out = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'class') out.className = value;
    else if (name.startsWith('on')) out.addEventListener(name.slice(2), value);
    else if (value === true) out.setAttribute(name, '');
    else if (value !== false && value !== undefined) out.setAttribute(name, value);
  }
  out.append(...children);
  return out;
}
