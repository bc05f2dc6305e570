// Made for this interface, but compiled when a type that it hands over had another size.
#include <cstdint>

#include "core/version.h"

extern "C" __attribute__((visibility("default"))) int blossomPluginApi() { return blossom::pluginApiVersion; }
extern "C" __attribute__((visibility("default"))) std::uint32_t blossomPluginLayout() { return 7; }
extern "C" __attribute__((visibility("default"))) void blossomRegister(void*) { __builtin_trap(); }
