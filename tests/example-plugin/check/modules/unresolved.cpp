extern "C" int nobodyHasThis();
extern "C" __attribute__((visibility("default"))) int blossomPluginApi() { return nobodyHasThis(); }
extern "C" __attribute__((visibility("default"))) void blossomRegister(void*) {}
