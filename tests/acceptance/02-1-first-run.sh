#!/usr/bin/env bash
# Clone, ./dev run, ./dev test in an empty directory: no other step
# (A machine without the packages is simulated with BLOSSOM_ACCEPT_ROOT=FOLDER: a Debian 12 tree to chroot into.)
clone=$(mktemp -d)
if [ -n "${BLOSSOM_ACCEPT_ROOT:-}" ]; then
  enter=(chroot "$BLOSSOM_ACCEPT_ROOT" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 TERM=dumb)
  folder=/tmp/blossom-first-run; rm -rf "$BLOSSOM_ACCEPT_ROOT$folder"
  git clone -q "$root" "$BLOSSOM_ACCEPT_ROOT$folder"
else
  enter=(env -u DISPLAY -u WAYLAND_DISPLAY)
  folder=$clone/blossom
  git clone -q "$root" "$folder"
fi
started=$(date +%s)
"${enter[@]}" env CCACHE_DISABLE=1 bash -c "cd $folder && ./dev build" >"$out/first-build.log" 2>&1; built=$?
seconds=$(($(date +%s) - started))
equal "clean release build with tests, exit code" "$built" 0
at_most "  its time on $(nproc) cores, packages and no compiler cache included" "$(awk -v s=$seconds 'BEGIN { printf "%.1f", s / 60 }')" 15 min
"${enter[@]}" env CCACHE_DISABLE=1 bash -c "cd $folder && ./dev run" >"$out/first-run.log" 2>&1
equal "./dev run without a display, exit code" "$?" 0
made=${BLOSSOM_ACCEPT_ROOT:-}$folder/out
for file in propeller.step propeller.igs propeller.png; do
  at_least "  it made out/$file" "$(stat -c %s "$made/$file" 2>/dev/null)" 1000 bytes
done
"${enter[@]}" env CCACHE_DISABLE=1 bash -c "cd $folder && ./dev test" >"$out/first-test.log" 2>&1
equal "./dev test, exit code" "$?" 0
report PASS "  $(grep -oE '[0-9]+% tests passed.*' "$out/first-test.log" | tail -1)" "" ""
rm -rf "$clone"
