#pragma once
#include <string>
#include <vector>

#include "kernel/path/pocket_path.h"

namespace blossom::pocket {

/// Warnings about options that are possible but unusual, with figure and remedy, as full sentences.
std::vector<std::string> adviceOn(const PocketOptions&);

}  // namespace blossom::pocket
