#!/bin/sh
# check_bundle.sh BUILD CMAKE NAME: packs the bundle, unpacks it elsewhere, and runs its check there.
set -eu
build=$1
"$2" --build "$build" --target bundle >/dev/null
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
tar -xzf "$build/$3.tar.gz" -C "$here"
cd "$here/$3"
# Nothing of the user's: no HOME, no drivers named, no repository in sight.
env -i PATH=/usr/bin:/bin CHECK_SECONDS=75 ./check.sh "$here/out" >"$here/log" 2>&1 || true
fail() { echo "device check: $1"; cat "$here/log"; exit 1; }
[ -s "$here/out/summary.txt" ] || fail "no summary"
grep -q '^== doctor: exit code 0' "$here/out/summary.txt" || fail "doctor did not run"
grep -q 'timestamps\|timer' "$here/out/summary.txt" || fail "doctor said nothing of timers"
for step in quick validated files stability scaling accuracy; do
  grep -q "^== $step: " "$here/out/summary.txt" || fail "step $step is missing"
done
# Cut by its time or ended by itself: nothing else may have gone wrong.
if grep -E '^== [a-z-]+: exit code' "$here/out/summary.txt" | grep -vE 'exit code (0|124),'; then
  fail "a step failed"
fi
tar -tzf "$here/out/files.tar.gz" | grep -q 'files/quick.err' || fail "no files of the steps"
