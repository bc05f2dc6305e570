// Its manifest may say what it likes: the module itself was made for another interface.
extern "C" __attribute__((visibility("default"))) int blossomPluginApi() { return 999; }
extern "C" __attribute__((visibility("default"))) void blossomRegister(void*) { __builtin_trap(); }
