#!/usr/bin/env bash
# Debian 12 and 13: each is built from a bare machine, and both give the same figures
if [ "$(. /etc/os-release && echo "$VERSION_CODENAME")" = trixie ]; then
  other=bookworm minutes=9
else
  other=trixie minutes=11
fi
bare=${BLOSSOM_ACCEPT_DEBIAN:-$(mktemp -d)/debian} # a Debian that is kept between calls
on_other() { "$root/packaging/on-debian" --keep "$bare" "$other" "$@"; }

CCACHE_DISABLE=1 on_other run >"$out/bare-run.log" 2>&1
equal "./dev run on a bare $other: exit code" "$?" 0
grep -E '^(Debian .* unpacked|Installed) in' "$out/bare-run.log" | sed 's/^/      /'
at_most "  its build on $(nproc) cores" "$(sed -nE 's/^built in ([0-9]+) s$/\1/p' "$out/bare-run.log" | awk '{ printf "%.1f", $1 / 60 }')" "$minutes" min

# The same commands on both: the five of the README and every sample document.
commands=$(
  grep -E '^blossom .* -o out/' "$root/README.md"
  for document in "$root"/resources/samples/*.blossom; do echo "blossom run resources/samples/$(basename "$document")"; done
)
all_of_them="mkdir -p out; export PATH=\$BIN:\$PATH; $(sed 's/$/ --json; echo/' <<<"$commands")"
(cd "$root" && BIN=$bin bash -c "$all_of_them") >"$out/figures-here.json" 2>"$out/figures-here.log"
on_other -- env BIN=/root/blossom/build/release/bin bash -c "$all_of_them" >"$out/figures-there.json" 2>"$out/figures-there.log"

# Every number and word of the answers but times, one a line.
figures() { grep -oE '"[A-Za-z_0-9.-]+": *("[^"]*"|[-+0-9.eE]+|true|false)' "$1" | grep -vE '^"([a-z_]*_)?ms":'; }
for side in here there; do figures "$out/figures-$side.json" >"$out/figures-$side.txt"; done
equal "commands that answer on this machine" "$(grep -c '"stats"\|"features"' "$out/figures-here.json")" "$(wc -l <<<"$commands")"
equal "figures in the answers of both" "$(wc -l <"$out/figures-there.txt")" "$(wc -l <"$out/figures-here.txt")"
paste -d '|' "$out/figures-here.txt" "$out/figures-there.txt" | awk -F '|' '
  function value(text) { sub(/^"[^"]*": */, "", text); return text }
  {
    a = value($1); b = value($2)
    if (a ~ /^[-+]?[0-9]/ && b ~ /^[-+]?[0-9]/) {
      scale = a < 0 ? -a : a; if (scale < 1) scale = 1
      difference = (a - b) / scale; if (difference < 0) difference = -difference
      if (difference > largest) largest = difference
      if (difference > 1e-9) print $1, "there:", b > "/dev/stderr"
    } else if ($1 != $2) { largest = 1; print $1, "there:", $2 > "/dev/stderr" }
  }
  END { printf "%.2g\n", largest }' >"$out/difference.txt" 2>"$out/differences.log"
at_most "  the largest difference of one, relative" "$(cat "$out/difference.txt")" 1e-9
head -n 20 "$out/differences.log" | sed 's/^/      /'

on_other package >"$out/bare-package.log" 2>&1
equal "./dev package on a bare $other: exit code" "$?" 0
equal "  a package of that release" "$(ls "$bare"/root/blossom/out/*~deb*.deb 2>/dev/null | wc -l)" 1
on_other test >"$out/bare-test.log" 2>&1
equal "./dev test on a bare $other: exit code" "$?" 0
grep -E 'tests passed|tests failed' "$out/bare-test.log" | sed 's/^/      /'
[ -n "${BLOSSOM_ACCEPT_DEBIAN:-}" ] || rm -rf --one-file-system "$(dirname "$bare")"
