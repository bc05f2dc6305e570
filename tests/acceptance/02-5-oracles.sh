#!/usr/bin/env bash
# Oracles, the real binary, and rubbish
for test in "$build"/tests/bin/*_test; do
  name=$(basename "$test")
  case $name in
    window_test | mutated_files_test | text_formats_test | cad_formats_test | step_roundtrip_test) ;;
    product_test | sweep_*_test | bspline_occt_test | cli_test) qtest "$name" "$test" ;;
  esac
done
qtest "the window (Xvfb)" "$build/tests/bin/window_test"
# 2,000 mutated files through every reader, under AddressSanitizer
if BLOSSOM_PRESET=asan "$root/dev" build mutated_files_test blossom-worker >"$out/asan-build.log" 2>&1; then
  qtest "2,000 mutated files through every reader under ASan and UBSan" "$root/build/asan/tests/bin/mutated_files_test" \
    BLOSSOM_FUZZ_FILES=2000 ASAN_OPTIONS=detect_leaks=0 BLOSSOM_SHARED_DATA="$data"
else
  report FAIL "sanitizer build" "see asan-build.log" "builds"
fi
