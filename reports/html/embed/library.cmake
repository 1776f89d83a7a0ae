# cmake -DOUT=FILE -DVEGA=FOLDER -DMODULES=a,b,c -DHERE=FOLDER -P library.cmake
# The parts of Vega that the report draws with, as one script: each module in a function of its own
# behind a `require` of a few lines, so that equal names of two modules do not meet. What the page
# uses is left in `vegaLibrary`.
string(REPLACE "," ";" modules "${MODULES}")
file(READ ${HERE}/library_notice.txt notice)
file(WRITE ${OUT} "/*!\n${notice}*/\n")
file(READ ${HERE}/library_loader.js loader)
file(APPEND ${OUT} "const vegaLibrary = (() => {\n${loader}")
foreach(module ${modules})
  file(READ ${VEGA}/vega-${module}.min.js text)
  # Browsers would ask for the map.
  string(REGEX REPLACE "//# sourceMappingURL=[^\n]*\n?" "" text "${text}")
  file(APPEND ${OUT} "define('vega-${module}', (exports, module, require) => {\n${text}\n});\n")
endforeach()
file(APPEND ${OUT} "return require;\n})();\n")
