#!/bin/sh
# Starts the bundled program. Libraries that GPU drivers need too (lib/fallback) are the system's
# where it has them: a driver may need newer ones than these.
here=$(dirname "$(readlink -f "$0")")
known=$( (/sbin/ldconfig -p || ldconfig -p) 2>/dev/null)
for folder in "$here"/lib/fallback/*; do
  case $known in
    *"$(basename "$folder") (libc6,x86-64"*) ;;
    *) LD_LIBRARY_PATH=$folder${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}; export LD_LIBRARY_PATH ;;
  esac
done
exec "$here/bin/bench" "$@"
