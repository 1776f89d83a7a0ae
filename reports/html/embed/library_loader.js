// A `require` for the modules that follow, in an order in which none needs a later one.
const loaded = {};
function define(name, body) {
  const module = { exports: {} };
  body(module.exports, module, require);
  loaded[name] = module.exports;
}
function require(name) {
  // Two of the modules know this one by its older name.
  const found = loaded[name === 'vega-selections' ? 'vega-selection' : name];
  if (!found) throw new Error(`${name} is not embedded`);
  return found;
}
