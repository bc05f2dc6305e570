#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Warnings for the operator of the machine about a program that is read.
namespace blossom {

/// Follows the modes of the machine that do not move the tool, and reports what looks like a mistake: lengths without a
/// unit, the length offset of another tool, cuts with a stopped spindle, corners rounded without a limit.
class GcodeWatch {
 public:
  void at(std::size_t line) { line_ = line; }

  void unitsSaid() { unitsSaid_ = true; }
  void toolMade(int number) { chosen_ = {number, line_}; }  ///< T
  void toolChanged();                                       ///< M6
  void lengthFrom(std::optional<int> number);               ///< G43, with H when it is there
  void lengthNumber(int number);                            ///< H without G43
  void noLength();                                          ///< G49
  /// A work offset is chosen instead of the one before. @param moved the tool has moved in the one before
  void workOffset(const std::string& name, bool moved);
  void spindleTurns();
  void spindleStops();
  void blendsWithoutLimit();                  ///< G64 without P
  void blends(double mm);                     ///< G64 P
  void endsBefore(const std::string& by);     ///< "%", M2 or M30 ends the program, and more follows
  void endsPerhaps();                         ///< "%" in a program that does not begin with one
  void feed(std::optional<double> value);     ///< F; nothing for a parameter or an expression
  void speed(std::optional<double> value);    ///< S; the same
  void belowZero(char letter, double value);  ///< a word that controls refuse below 0

  void moves();  ///< a motion with coordinates
  void cuts();   ///< a motion with coordinates other than a rapid

  /// Sentences such as "line 12 cuts ..", in the order of their lines, with a limit for each kind.
  [[nodiscard]] std::vector<std::string> doubts() const;
  /// The doubts that also concern a drawing made of the program.
  [[nodiscard]] std::vector<std::string> drawingDoubts() const;

 private:
  using Noted = std::vector<std::pair<std::size_t, std::string>>;
  struct Numbered {
    int number = 0;
    std::size_t line = 0;
  };
  static void note(Noted& where, std::size_t line, std::string what);
  void checkLength();
  void checkFeed();
  void checkSpindle();

  std::size_t line_ = 0;
  bool unitsSaid_ = false, unitsDoubted_ = false;
  std::optional<Numbered> chosen_, tool_, length_;
  bool hasLength_ = false;                ///< a length of a tool is taken into account
  std::optional<std::size_t> cancelled_;  ///< where it was taken back
  bool changes_ = false;
  std::set<std::pair<int, int>> mismatches_;
  bool turning_ = false, everTurned_ = false, stillDoubted_ = false;
  bool feeds_ = false, feedDoubted_ = false;      ///< a feed above 0 is set; doubted since it was set last
  bool hasSpeed_ = false, speedDoubted_ = false;  ///< the same for the spindle's speed
  std::optional<std::size_t> stopped_;
  std::optional<std::pair<std::size_t, std::string>> offset_;  ///< the work offset that was chosen last, and its line
  Noted units_, ends_, offsets_, lengths_, still_, corners_, feeding_, negative_;
};

}  // namespace blossom
