#!/usr/bin/env bash
# The real window under Xvfb, from the first file to the last kill
scenario() { qtest "$1" "$build/tests/bin/$2"; }
scenario "open by drop, pick a face, edit with live preview, undo, redo, reorder, palette, cancel, save" workbench_test
scenario "draw an outline with snapping and typed lengths, extrude and fillet it" modeling_window_test
scenario "measure and section" measure_window_test
scenario "the view: picking of features, faces, edges and points, tools, navigation" view_test
scenario "the panel: a field for every kind of parameter" property_panel_test
scenario "the tree: rename, isolate, delete, reorder, suppress, search" document_tree_test
scenario "the palette" palette_test
scenario "files: open, save, guard, damaged documents" window_files_test
scenario "50 times kill -9 in the middle of a save and of an edit, recovered" recovery_test
at_least "  rounds of them" "$(figure recovery_test rounds)" 50
equal "  edits lost that were older than a second" "$(figure recovery_test lost)" 0
