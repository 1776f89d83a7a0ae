# cmake -DOUT=FILE -DFILES=a,b,c [-DSCOPE=ON] -P page.cmake
# Files one after the other; with SCOPE within a function, so that a script's names are its own.
string(REPLACE "," ";" files "${FILES}")
file(WRITE ${OUT} "")
if(SCOPE)
  file(APPEND ${OUT} "(() => {\n'use strict';\n")
endif()
foreach(file ${files})
  file(READ ${file} text)
  file(APPEND ${OUT} "${text}")
endforeach()
if(SCOPE)
  file(APPEND ${OUT} "})();\n")
endif()
