#!/bin/sh
# What one device says of the program, in at most six minutes and without a network:
#   check.sh [FOLDER]      writes to FOLDER, else to $OUT, else to ./check
# Beside it lie the program (`bench`) and `scenes`: cmake --build build --target bundle puts them
# there. Each step has a share of the time, and is interrupted when it is over: what it has by then
# is written. Exit code: 0 when every step ended by itself with 0. README.md says what to look for.
set -u
here=$(cd "$(dirname "$0")" && pwd)
bench=${BENCH:-$here/bench}
out=${1:-${OUT:-check}}
seconds=${CHECK_SECONDS:-340}
work=$out/files
mkdir -p "$work" || exit 2
start=$(date +%s)
summary=$out/summary.txt
: >"$summary"
failed=0

say() { printf '%s\n' "$*" | tee -a "$summary"; }

step() { # $1 name, $2 share of the whole time in percent; then bench's arguments
  name=$1 share=$(($2 * seconds / 100))
  shift 2
  [ "$name" = doctor ] && [ $share -lt 40 ] && share=40 # software devices measure their timers slowly
  left=$((start + seconds - $(date +%s)))
  [ $share -gt $left ] && share=$left
  if [ $share -lt 2 ]; then
    say "== $name: no time left"
    failed=1
    return
  fi
  began=$(date +%s)
  # The first signal ends the cell under way and writes all that is finished.
  timeout --signal=INT --kill-after=15 $share "$bench" "$@" >"$work/$name.txt" 2>"$work/$name.err"
  code=$?
  say "== $name: exit code $code, $(($(date +%s) - began)) s: bench $*"
  grep -v '^\[' "$work/$name.err" | tail -n 12 | tee -a "$summary"
  [ $code = 0 ] || failed=1
}

run() { # a step that measures
  name=$1 share=$2
  shift 2
  step "$name" "$share" "$@" --json "$work/$name.json" --html "$work/$name.html"
  [ -f "$work/$name.txt" ] && tail -n 60 "$work/$name.txt" >>"$summary"
}

step doctor 6 doctor
cat "$work/doctor.txt" >>"$summary"
# The picture of every cell is compared with that of the other API, pixel by pixel (column picture).
run quick 22 --budget 0.2 --seeds 8
run validated 10 --validate --budget 0.1 --seeds 2 --size 128x128 --scene window --scene teapot
run files 6 --budget 0.1 --seeds 2 --size 256x256 \
  --scene "$here/scenes/lights.gltf" --scene "$here/scenes/textured.gltf"
run stability 18 --suite stability_short
run scaling 12 --suite coloured_scaling --budget 0.1 --seeds 1
run accuracy 18 --suite accuracy --budget 0.05 --seeds 8
for scene in window teapot; do
  for backend in vulkan opengl; do
    step "picture-$scene-$backend" 2 render --technique CSSM2 --scene $scene --size 512x512 \
      --backend $backend -o "$work/$scene-$backend"
  done
done

for page in quick stability accuracy; do
  [ -f "$work/$page.html" ] && cp "$work/$page.html" "$out/"
done
(cd "$out" && tar -czf files.tar.gz files && rm -r files)
[ $failed = 0 ] && say "== all steps ended" || say "== some step failed or was cut"
exit $failed
