#!/usr/bin/env bash
# Files in and out: exports that end nothing, the same bytes twice, work that a signal ends, large shapes, rules of formats
export BLOSSOM_WORKER="$bin/blossom-worker"
place=$out/files
rm -rf "$place"; mkdir -p "$place/tmp"

# 18
qtest "assemblies and odd shapes to every format of solids" "$build/tests/bin/exported_shapes_test"
echo "      $(figure exported_shapes_test written) written whole, $(figure exported_shapes_test refused) refused with a sentence, nothing left beside them"

# 20
qtest "samples and feature types give the same bytes, with 1, 2 and 3 threads" "$build/tests/bin/reproducible_files_test"
echo "      $(figure reproducible_files_test samples) files of samples, $(figure reproducible_files_test types) feature types"
if [ -d "$data" ]; then
  for extension in step iges brep stl; do
    for run in 1 2; do
      SOURCE_DATE_EPOCH=1700000000 "$bin/blossom" convert "$data/step/as1-oc-214.stp" "$place/assembly$run.$extension" --threads "$run" >/dev/null 2>&1
    done
    equal "bytes of an assembly as $extension, twice" "$(cmp -s "$place"/assembly[12].$extension && echo same)" same
  done
else
  report SKIP "bytes of an assembly, twice" "no data" "same"
fi

# 21
qtest "faces of 200,000 corners, figures beyond all numbers, 200,000 features" "$build/tests/bin/endless_work_test"
qtest "signals end deaf work, its helpers and what it laid down" "$build/tests/bin/interruption_test"
awk 'BEGIN { srand(7); for (i = 0; i < 60000; i++) print "v", rand() * 100, rand() * 100, 0; printf "f"; for (i = 1; i <= 60000; i++) printf " %d", i; print "" }' >"$place/crossing.obj"
awk 'BEGIN { n = 3000000; for (i = 0; i < n; i++) { a = 6.283185307179586 * i / n; r = 100 + i % 2; print "v", r * cos(a), r * sin(a), 0 } printf "f"; for (i = 1; i <= n; i++) printf " %d", i; print "" }' >"$place/star.obj"
start=$(date +%s%N)
"$bin/blossom" info "$place/crossing.obj" >/dev/null 2>&1
at_most "a face of 60,000 crossing corners is measured (200 s before)" "$(awk -v t=$(($(date +%s%N) - start)) 'BEGIN { print t / 1e9 }')" 20 s
ends() { # what seconds-before-the-signal words..
  local what=$1 before=$2 start pid; shift 2
  TMPDIR=$place/tmp "$bin/blossom" "$@" >/dev/null 2>&1 & pid=$!
  sleep "$before"
  start=$(date +%s%N)
  kill -TERM "$pid"; wait "$pid" 2>/dev/null
  at_most "SIGTERM ends $what" "$(awk -v t=$(($(date +%s%N) - start)) 'BEGIN { printf "%.2f", t / 1e9 }')" 0.5 s
}
ends "reading 3,000,000 corners" 1 info "$place/star.obj"
ends "measuring 3,000,000 corners" 6 info "$place/star.obj"
[ ! -d "$data" ] || ends "writing in a helper" 1 convert "$data/step/as1-oc-214.stp" "$place/stopped.iges"
equal "temporary files after these" "$(find "$place/tmp" -mindepth 1 | wc -l)" 0
printf '0,0,0;0,1e308,0\n1e308,0,0;1e308,1e308,0\n' >"$place/huge.cpt"
equal "the area of control points of 1e308" "$("$bin/blossom" info "$place/huge.cpt" --json 2>/dev/null | json code)" LimitExceeded

# 23
TMPDIR=$place/tmp "$bin/blossom" info "$place/star.obj" >/dev/null 2>&1 & pid=$!
mkdir -m 700 "$place/tmp/blossom-temporary-Aban1x"
sleep 1; kill -KILL "$pid"; wait "$pid" 2>/dev/null
TMPDIR=$place/tmp "$bin/blossom" features >/dev/null 2>&1
equal "folders of ended programs after the next start" "$(find "$place/tmp" -mindepth 1 | wc -l)" 0
message=$(TMPDIR=$place/missing "$bin/blossom" convert "$root/tests/fixtures/sheet.cpt" "$place/x.step" --json 2>/dev/null | json message)
equal "a missing TMPDIR is named" "$([[ $message == *"$place/missing"* ]] && echo named)" named
message=$(ulimit -f 1; "$bin/blossom" convert ball:50:3 "$place/full.stl" --json 2>/dev/null | json message)
equal "a full disk names the user's file" "$([[ $message == *"$place/full.stl"* && $message != *writing-* ]] && echo named)" named
cp "$root/tests/fixtures/tetrahedron.off" "$place/-odd.off"
equal "-- ends flags" "$(cd "$place" && "$bin/blossom" info --json -- -odd.off 2>/dev/null | json faces)" 4
"$bin/blossom" info "$place/none.stl" "$place/-odd.off" --json >"$place/info.json" 2>/dev/null; code=$?
equal "info of a missing and of a good file: exit code and faces" "$code $(json faces <"$place/info.json")" "1 4"
qtest "what 3MF forbids is told or refused" "$build/tests/bin/three_mf_rules_test"
echo "      $(figure three_mf_rules_test told) told, $(figure three_mf_rules_test refused) refused"
