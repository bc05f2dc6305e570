#!/usr/bin/env bash
# Subdivision: published positions, local deformation, live dragging, export
tests=$build/tests/bin
qtest "refined cages against published positions and rules written again" "$tests/subdivision_refine_test"
at_least "  published files compared, levels 1 and 2, all cages" "$(figure subdivision_refine_test baseline_files)" 24
at_most "  largest distance of a vertex or a face" "$(figure subdivision_refine_test baseline_error)" 1e-6
qtest "limit surfaces against the exact masks; cages that are refused" "$tests/subdivision_surface_test"
qtest "curves: cubic, quadratic, four-point" "$tests/subdivision_curve_test"
qtest "deformation: support rule, paper's rule, rings, pulls" "$tests/subdivision_deform_test"
qtest "what deformation reports, against a search over every triangle" "$tests/subdivision_pull_test"
at_least "  points outside the support compared bit by bit" "$(figure subdivision_pull_test outside_points)" 10000
equal "  of them changed" "$(figure subdivision_pull_test outside_changed)" 0
at_most "  RMS distance after / before, worst of $(figure subdivision_pull_test pulled_cases) random cases" "$(figure subdivision_pull_test rms_ratio)" 0.5
at_most "  reported distances against those found independently" "$(figure subdivision_pull_test rms_error_mm)" 5e-3 mm
qtest "B-spline faces: few, exact on regular regions, closed" "$tests/subdivision_faces_test"
qtest "STEP files as OCCT's reader and checker see them" "$tests/subdivision_step_test"
at_most "  limit points off the faces of regular cages" "$(figure subdivision_step_test step_regular_deviation_mm)" 1e-6 mm
at_most "  limit points off the faces, tolerance 0.001 mm" "$(figure subdivision_step_test step_deviation_mm)" 1e-3 mm
at_least "  real cages written, valid, bicubic" "$(figure subdivision_step_test step_real_cages)" 16

qtest "live dragging in the kernel" "$tests/subdivision_live_test"
at_most "  5,000 faces: one movement of the mouse" "$(figure subdivision_live_test move_ms)" 16 ms
at_most "  5,000 faces: taking hold of a point" "$(figure subdivision_live_test grab_ms)" 50 ms
qtest "the window: from a cage to a saved file by stroke, points and targets" "$tests/subdivision_window_test" BLOSSOM_PICTURES="$out"
at_most "  5,000 faces: the window's thread blocked at most while dragging" "$(figure subdivision_window_test drag_stall_ms)" 50 ms
at_least "  5,000 faces: frames drawn while dragging, in software" "$(figure subdivision_window_test drag_frames_per_s)" 15 "frames/s"
echo "      of it computing $(figure subdivision_window_test drag_stall_computing_ms) ms; when selected $(figure subdivision_window_test drag_select_stall_ms) ms, when let go $(figure subdivision_window_test drag_drop_stall_ms) ms"
echo "      look at pulled-*.png and dragged-*.png in ${out#"$root"/}"

# On the command line: the same cage to OBJ, STL and STEP, and the numbers that --json prints
cage=$out/cage.obj target=$out/target.xyz
printf 'v %s\n' "-20 -20 -20" "20 -20 -20" "20 20 -20" "-20 20 -20" "-20 -20 20" "20 -20 20" "20 20 20" "-20 20 20" >"$out/box.obj"
printf 'f %s\n' "4 3 2 1" "5 6 7 8" "1 2 6 5" "2 3 7 6" "3 4 8 7" "4 1 5 8" >>"$out/box.obj"
"$bin/blossom" subdivide "$out/box.obj" --levels 2 -o "$cage" >"$out/subdivide.log" 2>&1
awk 'BEGIN { for (x = -8; x <= 8; x += 0.8) printf "%g 0 %g\n", x, 14 + 8 * cos(x * 0.196) }' >"$target"
answer=$("$bin/blossom" deform "$cage" "$target" -o "$out/deformed.obj,$out/deformed.stl,$out/deformed.step" --json 2>>"$out/subdivide.log")
equal "deform: OBJ, STL and STEP in one call, exit code" "$?" 0
equal "  outside_change" "$(json outside_change <<<"$answer")" 0.0
before=$(json rms_before <<<"$answer") after=$(json rms_after <<<"$answer")
at_most "  rms_after, of rms_before $before" "$after" "$(awk -v b="$before" 'BEGIN { print b / 5 }')" mm
check=$("$tests/check_solid" "$out/deformed.step" "$out/deformed.stl" 0.1)
equal "  STEP solid closed and valid (OCCT)" "$(json valid <<<"$check")" true
changed=$(diff <(grep '^v' "$cage") <(grep '^v' "$out/deformed.obj") | grep -c '^>')
at_most "  vertices of the OBJ that changed, of $(grep -c '^v' "$cage")" "$changed" "$(json free_points <<<"$answer")"
drawing() { # file, points as "x y"..: an open polyline
  local file=$1; shift
  { printf '0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n%d\n70\n0\n' $#; for p in "$@"; do printf '10\n%s\n20\n%s\n' $p; done; printf '0\nENDSEC\n0\nEOF\n'; } >"$file"
}
drawing "$out/polygon.dxf" "0 0" "10 12" "22 -6" "34 10" "45 0" "56 8"
drawing "$out/wanted.dxf" "12 4" "17 6" "22 7" "28 7" "34 5"
for scheme in cubic quadratic four-point; do
  answer=$("$bin/blossom" deform "$out/polygon.dxf" "$out/wanted.dxf" --scheme $scheme -o "$out/curve-$scheme.dxf" --json 2>>"$out/subdivide.log")
  equal "curve, $scheme: exit code and outside_change" "$?, $(json outside_change <<<"$answer")" "0, 0.0"
done
