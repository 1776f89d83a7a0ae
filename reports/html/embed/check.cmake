# cmake -DSCRIPT=FILE -P check.cmake
# Refuses a script that could end its own tag, and writes the SHA-256 beside it, in hexadecimal
# digits: the page's policy runs scripts of these hashes alone.
file(READ ${SCRIPT} text)
if(text MATCHES "</[sS][cC][rR][iI][pP][tT]" OR text MATCHES "<!--")
  message(FATAL_ERROR "${SCRIPT} holds </script or <!--, which HTML would read as markup")
endif()
file(SHA256 ${SCRIPT} hash)
file(WRITE ${SCRIPT}.sha256 "${hash}")
