#pragma once
#include <vector>

#include "ui/help/tour.h"

namespace blossom::ui {

class MainWindow;

/// The four things that somebody new should have seen: samples, tree, properties, and canvas with palette.
std::vector<TourStep> windowTour(MainWindow&);

}  // namespace blossom::ui
