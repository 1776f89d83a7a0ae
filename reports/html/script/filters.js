// What is shown: every element that says which technique, backend, scene or kind of error it is of
// is hidden unless all that it says is chosen.
const kFiltered = '[data-technique], [data-backend], [data-backends], [data-scene], [data-kind]';

function readFilters(form) {
  const checked = (name) => new Set(
    [...form.querySelectorAll(`input[name=${name}]:checked`)].map((input) => input.value));
  return {
    techniques: new Set([...form.querySelectorAll('input[name=technique]')].map((i) => i.value)),
    technique: checked('technique'), backend: checked('backend'), kind: checked('kind'),
    scene: form.elements.scene.value,
  };
}

function passes(filters, { technique, backend, backends, scene, kind }) {
  // A name that nobody can choose is never hidden: a trade-off may speak of a family of techniques.
  return (technique === undefined || !filters.techniques.has(technique) ||
      filters.technique.has(technique)) &&
    (backend === undefined || filters.backend.has(backend)) &&
    (backends === undefined || JSON.parse(backends).some((name) => filters.backend.has(name))) &&
    (kind === undefined || filters.kind.has(kind)) &&
    (scene === undefined || !filters.scene || filters.scene === scene);
}

function applyFilters(form) {
  const filters = readFilters(form);
  for (const node of document.querySelectorAll(kFiltered)) node.hidden = !passes(filters, node.dataset);
  const rows = [...document.querySelectorAll('table.cells tbody tr')];
  const shown = rows.filter((row) => !row.closest('[hidden]')).length;
  document.getElementById('shown').value = `${shown} of ${rows.length} cells`;
  return filters;
}
