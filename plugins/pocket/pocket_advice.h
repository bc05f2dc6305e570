#pragma once
#include <string>
#include <vector>

#include "kernel/path/pocket_path.h"

namespace blossom::pocket {

/// What can be made and would hardly be meant: each with its figure and a remedy, as full sentences.
std::vector<std::string> adviceOn(const PocketOptions&);

}  // namespace blossom::pocket
