#!/usr/bin/env bash
# Rubbish is refused with a sentence and a remedy, and nothing falls over
qtest "every feature type, every input, every kind of rubbish" "$build/tests/bin/rubbish_shapes_test"
echo "      $(figure rubbish_shapes_test refused) refused, $(figure rubbish_shapes_test taken) mended or harmless"
rubbish=$out/rubbish
mkdir -p "$rubbish"
: >"$rubbish/empty.svg"
: >"$rubbish/empty.off"
echo '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm" viewBox="0 0 10 10"><path d="M0 0L10 10' >"$rubbish/cut-off.svg"
echo '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm" viewBox="0 0 10 10"><path d="M0 0L10 0L10 10"/><path d="M1 1L2 2"/></svg>' >"$rubbish/open.svg"
echo '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm" viewBox="0 0 10 10"><path d="M0 0L10 10V0L0 10Z"/></svg>' >"$rubbish/bow-tie.svg"
printf 'OFF\n4 4 0\n0 0 0\n1 0 nan\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n' >"$rubbish/nan.off"
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n' >"$rubbish/open.off"
printf 'OFF\n5 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 2 -1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 1 4\n' >"$rubbish/fin.off"
head -c 2000 /dev/urandom >"$rubbish/noise.step"

refused=0
refuses() { # what, the command's words
  local what=$1 answer code; shift
  answer=$(cd "$rubbish" && timeout 120 "$bin/blossom" "$@" --json 2>"$out/refusal.err"); code=$?
  printf '%s\n  exit %s %s\n' "$*" "$code" "$answer" >>"$out/refusals.txt"
  if [ "$code" = 1 ] && [ -n "$(json message <<<"$answer")" ] && [ -n "$(json hint <<<"$answer")" ]; then
    refused=$((refused + 1))
  else
    report FAIL "$what" "exit $code" "exit 1, message and hint"
  fi
}
: >"$out/refusals.txt"
for file in empty.svg cut-off.svg open.svg bow-tie.svg noise.step empty.off missing.svg; do
  for words in "morph $file circle:5" "morph circle:5 $file" "minkowski-sum $file circle:5" "minkowski-difference $file circle:5"; do
    [ "$words" = "minkowski-sum open.svg circle:5" ] || refuses "$words" $words -o out.svg  # open curves can be added
  done
  for words in "offset $file --distance 1" "medial-axis $file"; do refuses "$words" $words -o out.dxf; done
  refuses "pocket $file" pocket "$file" --tool-diameter 1 --depth 1 -o out.ngc
done
for file in empty.off nan.off open.off fin.off noise.step missing.stl; do
  for command in solid-sum solid-difference solid-open solid-close solid-morph; do
    refuses "$command $file" $command "$file" ball:1:1 -o out.off
    [ "$command" = solid-morph ] || refuses "$command ball $file" $command ball:1:1 "$file" -o out.off
  done
  for command in inflate melt; do refuses "$command $file" $command "$file" --radius 0.1 -o out.off; done
done
for file in empty.off nan.off fin.off noise.step missing.obj; do
  refuses "subdivide $file" subdivide "$file" --levels 1 -o out.obj
  refuses "deform $file" deform "$file" "$root/tests/fixtures/points.xyz" -o out.obj
done
refuses "no solution: a tool that does not fit" pocket circle:5 --tool-diameter 11 --depth 1 -o out.ngc
refuses "no solution: an offset further than the middle" offset circle:5 --distance 6 -o out.dxf
refuses "no solution: melted away" melt ball:2:1 --radius 3 -o out.off
report PASS "refusals on the command line, in ${out#"$root"/}/refusals.txt" "$refused" "with message and hint"
equal "files left behind by refusals" "$(find "$rubbish" -name 'out*' | wc -l)" 0
