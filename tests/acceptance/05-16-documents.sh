#!/usr/bin/env bash
# Numbers 16, 22 and 17: documents say what their commands said, read nothing unasked, and the window keeps what is there
tool=$(realpath "$bin/blossom")
in_out() { (cd "$out" && "$tool" "$@" --json 2>"$out/documents.err"); }

# 16: what convert prints is what the document holds.
surface=$data/nurbs/ex_surface01.cpt
if [ -e "$surface" ]; then
  printed=$(in_out convert "$(realpath "$surface")" o.blossom --control-points.degree-u 1 --control-points.degree-v 1 | json area)
  equal "16 area that info reads from the document that convert wrote" "$(in_out info o.blossom | json area)" "$printed"
  equal "16 the same by the command import" "$(in_out import "$(realpath "$surface")" --control-points.degree-u 1 --control-points.degree-v 1 | json area)" "$printed"
else
  report SKIP "16 area that info reads from the document that convert wrote" "no shared data" "the same"
fi

# 22: a file of the user, named by a stranger's document in all ways there are.
qtest "16, 22 options of readers, files of strangers, resources" "$build/tests/bin/cli_files_test"
ways=$(figure cli_files_test strangers_ways)
at_least "22 ways to name a file outside the document's folder" "$ways" 12
equal "22 of them read unasked" "$(figure cli_files_test strangers_read)" 0
equal "22 of them read with --allow-files" "$(figure cli_files_test strangers_allowed)" "$ways"
qtest "22 the window asks; 17 samples stay as they are" "$build/tests/bin/document_files_window_test"

# 17
qtest "17 what was cancelled says so and is computed" "$build/tests/bin/panel_form_test"
qtest "17 expressions stay as they were typed" "$build/tests/bin/panel_typing_test"
qtest "17 t is the time of the frame that is shown" "$build/tests/bin/timeline_window_test"
qtest "24 samples and what makes them name no folder" "$build/tests/bin/app_test"
equal "24 absolute paths in the samples" "$(figure app_test sample_paths)" 0
