#pragma once
#include <vector>

#include "ui/fields/parameter_field.h"

class QCheckBox;

namespace blossom::ui {

/// A titled group of fields, aligned with the fields around it. An optional record has a switch.
class RecordField final : public ParameterField {
 public:
  RecordField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;
  [[nodiscard]] Value written() const override;
  void setWritten(const Value&) override;
  /// Inside of a list the row has the title.
  void showAsItem();

 private:
  void display(const Value&) override;
  void addField(const ParameterSpec&);
  [[nodiscard]] Value with(const std::string& name, const Value&) const;

  Value draft_;  // what is shown; more than the value while something in it must still be given
  QWidget* body_;
  QCheckBox* switch_ = nullptr;
  std::vector<ParameterField*> fields_;
};

/// "6 mm · ball", "u 0.756 · v 0.911 · to 18.3, −2.1, 20": summary of a closed group, in three digits.
QString summaryOf(const ParameterSpec& record, const Value&);

}  // namespace blossom::ui
