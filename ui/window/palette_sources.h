#pragma once
#include <functional>

#include "ui/palette/palette_model.h"

namespace blossom::ui {

class Commands;
class DocumentPage;
class FeatureMenus;
class ManualPages;

/// Every command of the window, feature types of all plugins among them.
PaletteSource commandEntries(const Commands&, FeatureMenus&);
/// Samples, then the documents that were opened lately.
PaletteSource fileEntries(std::function<void(const QString& file)> open);
/// The features of the document that is shown: chosen, one is selected.
PaletteSource featureEntries(std::function<DocumentPage&()> page);
/// Pages of the manual. They are read when the palette first opens.
PaletteSource manualEntries(std::function<ManualPages()> read, std::function<void(const QString& page)> open);

}  // namespace blossom::ui
