extern "C" int aLibraryOfAnotherSort() { return 1; }
