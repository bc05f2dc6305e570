# Sourced by tests/acceptance/run. Every check prints one line: verdict, what, figure measured, figure asked for.
root=$(cd "$here/../.." && pwd)
bin=$build/bin
out=$root/out/acceptance/$issue
data=${BLOSSOM_SHARED_DATA:-$root/../shared/data}
mkdir -p "$out"
export LC_ALL=C LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
passed=0 failed=0 skipped=0

report() { # verdict what measured asked
  case $1 in PASS) passed=$((passed + 1)) ;; FAIL) failed=$((failed + 1)) ;; SKIP) skipped=$((skipped + 1)) ;; esac
  printf '  %-4s  %-66s %16s   %s\n' "$1" "$2" "$3" "$4"
}
at_most() { # what measured bound [unit]
  if awk -v a="${2:-none}" -v b="$3" 'BEGIN { exit !(a == a + 0 && a <= b) }'; then report PASS "$1" "$2 ${4:-}" "<= $3 ${4:-}"; else report FAIL "$1" "${2:-nothing} ${4:-}" "<= $3 ${4:-}"; fi
}
at_least() { # what measured bound [unit]
  if awk -v a="${2:-none}" -v b="$3" 'BEGIN { exit !(a == a + 0 && a >= b) }'; then report PASS "$1" "$2 ${4:-}" ">= $3 ${4:-}"; else report FAIL "$1" "${2:-nothing} ${4:-}" ">= $3 ${4:-}"; fi
}
equal() { # what measured wanted
  if [ "$2" = "$3" ]; then report PASS "$1" "$2" "= $3"; else report FAIL "$1" "${2:-nothing}" "= $3"; fi
}
with_display() { xvfb-run -a -s "-screen 0 1920x1200x24 +extension GLX" "$@"; }

# Runs one QtTest program and reports its totals; the log stays in $out.
qtest() { # what program [environment..]
  local what=$1 program=$2; shift 2
  local log=$out/$(basename "$program").log verdict=PASS totals
  with_display env QTEST_FUNCTION_TIMEOUT=3600000 "$@" timeout 3600 "$program" >"$log" 2>&1 || verdict=FAIL
  totals=$(grep -oE '[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped' "$log" | tail -1)
  [[ $totals == *" 0 skipped" ]] || [ "$verdict" = FAIL ] || verdict=SKIP
  report "$verdict" "$what" "${totals:-crashed}" "0 failed"
}
# A figure that a test printed as "figure NAME VALUE".
figure() { grep -ohE "figure $2 [-+0-9.eE]+" "$out/$1.log" | tail -1 | awk '{ print $3 }'; }
# A key of the JSON object on stdin, found by name (numbers and plain strings).
json() { grep -oE "\"$1\": *(\"([^\"\\\\]|\\\\.)*\"|[-+0-9.eE]+|true|false)" | head -1 | sed -E 's/^"[^"]*": *"?//; s/"$//'; }
