#pragma once
#include <vector>

#include "ui/help/tour.h"

namespace blossom::ui {

class MainWindow;

/// The four things that a new user should see first: samples, tree, properties, and canvas with palette.
std::vector<TourStep> windowTour(MainWindow&);

}  // namespace blossom::ui
