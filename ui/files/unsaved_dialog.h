#pragma once
#include <QDialog>
#include <QString>
#include <vector>

class QCheckBox;
class QPushButton;

namespace blossom::ui {

/// An entry of the dialog.
struct UnsavedDocument {
  QString name;
  bool wanted = true;  ///< initially selected for saving
};

/// Asks once what to do with several documents with unsaved changes.
class UnsavedDialog : public QDialog {
  Q_OBJECT
 public:
  enum class Answer { Save, Discard, Cancel };
  explicit UnsavedDialog(const std::vector<UnsavedDocument>& documents, QWidget* parent = nullptr);
  [[nodiscard]] Answer answer() const { return answer_; }
  [[nodiscard]] std::vector<std::size_t> chosen() const;  ///< indices of the documents to save

 private:
  void refresh();
  void finish(Answer);
  std::vector<QCheckBox*> boxes_;
  QPushButton* save_;
  Answer answer_ = Answer::Cancel;
};

}  // namespace blossom::ui
