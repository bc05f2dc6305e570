#!/usr/bin/env bash
# ./dev run of a clean clone without compiler cache: it builds what it runs
clone=$(mktemp -d)
git clone -q "$root" "$clone/blossom"
started=$(date +%s)
(cd "$clone/blossom" && packaging/install-dependencies build) >"$out/packages.log" 2>&1
echo "      packages installed in $(($(date +%s) - started)) s"
started=$(date +%s)
env -u DISPLAY -u WAYLAND_DISPLAY CCACHE_DISABLE=1 bash -c "cd $clone/blossom && ./dev run" >"$out/first-run.log" 2>&1
equal "./dev run, exit code" "$?" 0
at_most "  its time on $(nproc) cores" "$(awk -v s=$(($(date +%s) - started)) 'BEGIN { printf "%.1f", s / 60 }')" 9 min
at_most "  lines it prints" "$(wc -l <"$out/first-run.log")" 40
equal "  tests that it built" "$(find "$clone/blossom/build/release/tests" -name '*_test' -type f 2>/dev/null | wc -l)" 0
for file in propeller.step propeller.igs propeller.png; do
  at_least "  it made out/$file" "$(stat -c %s "$clone/blossom/out/$file" 2>/dev/null)" 1000 bytes
done
rm -rf "$clone"
