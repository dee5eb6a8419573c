// The parser of Wavefront OBJ: one pass over a text, or over a stretch of whole lines of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>

#include "core/base/counted_text.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/io/input_file.hpp"
#include "core/io/obj_parts.hpp"
#include "core/io/obj_reader.hpp"
#include "core/io/polygon_triangulation.hpp"

namespace footfall::detail {

inline constexpr Pattern kCorrectLine = FOOTFALL_TEXT("correct the line or export the file again");

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Throws InputError for a text with a NUL; `linesBefore` lines precede the text in its file.
inline void rejectBinary(const std::string& path, std::string_view text, std::size_t linesBefore = 0) {
  const std::size_t nul = text.find('\0');
  if (nul == std::string_view::npos) return;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  failInput(path, linesBefore + static_cast<std::size_t>(line), FOOTFALL_TEXT("has a NUL byte, so it is not OBJ text"),
            FOOTFALL_TEXT("give the file the extension of its real format, or export it as plain text"));
}

/// Counts of the text before a stretch.
struct ObjBefore {
  std::uint64_t vertices = 0;
  std::size_t lines = 0;
};

/// A face that is not a triangle. It is split, or left out, once all vertices are known, because a face may refer to
/// later vertices.
struct PendingPolygon {
  std::size_t trianglesBefore;  ///< number of triangular faces before it in the file
  std::size_t firstCorner;
  std::size_t cornerCount;
  std::size_t line;
  bool isFreeForm = false;  ///< a curved surface, without corners
};

/// The largest vertex index that was used before that many vertices were known, and its line.
struct ObjForwardReference {
  std::uint64_t index = 0;
  std::size_t line = 0;
};

/// Throws InputError when the whole file has fewer `vertices`.
inline void checkForwardReference(const std::string& path, const ObjForwardReference& largest, std::uint64_t vertices) {
  if (largest.index <= vertices) return;
  failInput(path, largest.line,
            Text(FOOTFALL_TEXT("vertex index %1 is out of range: the file has %2"), largest.index,
                 countedText(vertices, FOOTFALL_TEXT("1 vertex"), FOOTFALL_TEXT("%1 vertices"))),
            kCorrectLine);
}

/// Thrown where a stretch of the text cannot be read without the text before it.
struct NotAlone {};

/// One pass over the text, or over a stretch of whole lines of it. The text ends with a NUL and has no other, so that
/// the current character can always be read and is never a statement at the end.
class ObjParser {
 public:
  /// A Stretch is read by itself and throws NotAlone where it needs the text before it; an Ordered stretch gets those
  /// counts as ObjBefore.
  enum class Extent { Whole, Stretch, Ordered };

  ObjParser(const std::string& path, std::string_view text, Extent extent, Environment& environment,
            RunContext* context, ObjGroups* groups = nullptr, const ObjBefore& before = {})
      : path_(path),
        begin_(text.data()),
        cursor_(text.data()),
        end_(text.data() + text.size()),
        extent_(extent),
        verticesBefore_(before.vertices),
        environment_(environment),
        context_(context),
        groups_(groups),
        line_(before.lines + 1) {}

  /// Parses the whole text.
  void parse() {
    parseStatements();
    checkForwardReference(path_, {largestForward_, largestForwardLine_}, environment_.vertices.size());
    splitPolygons(environment_.vertices);
    ObjPartAssigner parts(environment_, environment_.triangles.size());
    parts.add(parts_, environment_.triangles.size());
    parts.finish();
  }

  void parseStatements() {
    const char* nextPoll = cursor_;
    while (cursor_ < end_) {
      if (cursor_ >= nextPoll) {
        poll();
        nextPoll = cursor_ + kPollBytes;
      }
      statement();
    }
  }

  /// The largest vertex index that was used before that many vertices were known, or 0; and its line.
  [[nodiscard]] std::uint64_t largestForward() const { return largestForward_; }
  [[nodiscard]] std::size_t largestForwardLine() const { return largestForwardLine_; }
  [[nodiscard]] bool hasPolygons() const { return !polygons_.empty(); }
  /// The statements that name parts; triangles are counted right after splitPolygons().
  [[nodiscard]] const ObjPartChanges& parts() const { return parts_; }

  /// The number of lines up to the end of this text, once it has been read, when it ends with a line end.
  [[nodiscard]] std::size_t lineCount() const { return line_ - 1; }

  /// Inserts the triangles of the polygons between those of the triangular faces, in the order of the file. `Vertices`
  /// is any type that triangulatePolygon() and skippedPolygon() accept.
  template <class Vertices>
  void splitPolygons(const Vertices& vertices) {
    if (polygons_.empty()) return;
    const std::vector<Triangle> faces = std::move(environment_.triangles);
    std::vector<Triangle>& triangles = environment_.triangles;
    triangles.clear();
    std::size_t split = 0;
    for (const PendingPolygon& polygon : polygons_) split += std::max<std::size_t>(polygon.cornerCount, 2) - 2;
    triangles.reserve(faces.size() + split);
    std::size_t copied = 0, cornersSincePoll = 0;
    std::vector<std::size_t> added = {0};
    added.reserve(polygons_.size() + 1);
    const auto copyUpTo = [&](std::size_t stop) {
      triangles.insert(triangles.end(), faces.begin() + static_cast<std::ptrdiff_t>(copied),
                       faces.begin() + static_cast<std::ptrdiff_t>(stop));
      copied = stop;
    };
    const auto poll = [this] {
      if (context_ != nullptr) context_->checkCancelled();
    };
    for (const PendingPolygon& polygon : polygons_) {
      cornersSincePoll += polygon.cornerCount;
      if (cornersSincePoll > kMostClippedCorners) {
        poll();
        cornersSincePoll = 0;
      }
      copyUpTo(polygon.trianglesBefore);
      const std::span<const std::uint32_t> corners(corners_.data() + polygon.firstCorner, polygon.cornerCount);
      if (!triangulatePolygon(corners, vertices, triangles, poll)) skip(polygon, corners, vertices);
      added.push_back(triangles.size() - copied);
    }
    copyUpTo(faces.size());
    moveGroups(added);
    parts_.countPolygons(added);
  }

 private:
  static constexpr std::ptrdiff_t kPollBytes = 1 << 20;  // about 5 ms of parsing

  [[noreturn]] void fail(const Text& what, const Text& todo = kCorrectLine) const {
    failInput(path_, line_, what, todo);
  }

  void needWhole() const {
    if (extent_ == Extent::Stretch) throw NotAlone{};
  }

  void poll() const {
    if (context_ == nullptr) return;
    context_->checkCancelled();
    if (extent_ == Extent::Whole)
      context_->progress(static_cast<double>(cursor_ - begin_) / static_cast<double>(end_ - begin_));
  }

  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
  static bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  [[nodiscard]] std::uint64_t knownVertices() const { return verticesBefore_ + environment_.vertices.size(); }

  [[nodiscard]] bool atLineEnd() const { return *cursor_ == '\n' || *cursor_ == '\0'; }
  [[nodiscard]] bool atEndOfValues() const { return atLineEnd() || *cursor_ == '#'; }

  /// Length of a "backslash, line end" at the cursor, or 0.
  [[nodiscard]] std::ptrdiff_t continuation() const {
    if (*cursor_ != '\\') return 0;
    const std::ptrdiff_t length = cursor_[1] == '\n' ? 2 : cursor_[1] == '\r' && cursor_[2] == '\n' ? 3 : 0;
    if (length != 0) needWhole();
    return length;
  }

  void skipBlanks() {
    for (;;) {
      while (isBlank(*cursor_)) ++cursor_;
      const std::ptrdiff_t length = continuation();
      if (length == 0) return;
      cursor_ += length;
      ++line_;
    }
  }

  void skipPhysicalLine() {
    const void* found = std::memchr(cursor_, '\n', static_cast<std::size_t>(end_ - cursor_));
    cursor_ = found == nullptr ? end_ : static_cast<const char*>(found) + 1;
    ++line_;
  }

  void skipStatement() {
    for (;;) {
      const char* start = cursor_;
      skipPhysicalLine();
      const char* last = cursor_ - 1;
      if (last > start && *last == '\n') --last;
      if (last > start && *last == '\r') --last;
      if (*last != '\\' || last < start) return;
      needWhole();
      if (cursor_ == end_) return;
    }
  }

  /// The rest of the current word, shortened, for messages.
  [[nodiscard]] std::string word(const char* start) const {
    constexpr std::ptrdiff_t kShown = 24;
    const char* stop = start;
    while (stop < end_ && !isBlank(*stop) && *stop != '\n') ++stop;
    std::string shown(start, std::min(stop, start + kShown));
    for (char& c : shown) {
      if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
    }
    return "'" + shown + (stop - start > kShown ? "...'" : "'");
  }

  /// Called where a statement lacks something.
  void rejectTruncation() const {
    if (*cursor_ == '\0')
      fail(FOOTFALL_TEXT("the file ends inside this line"), FOOTFALL_TEXT("it is truncated: copy or export it again"));
  }

  void statement() {
    skipBlanks();
    const char first = *cursor_;
    if (first == 'v' && isBlank(cursor_[1])) {
      ++cursor_;
      vertex();
    } else if (first == 'f' && isBlank(cursor_[1])) {
      ++cursor_;
      face();
    } else if (first == '#' || first == '\n' || first == '\0') {
      skipPhysicalLine();
    } else if (isLetter(first)) {
      otherStatement();
    } else {
      fail(Text(FOOTFALL_TEXT("not an OBJ statement: %1"), word(cursor_)),
           FOOTFALL_TEXT("is the file really OBJ? Rename it or export it again"));
    }
  }

  void vertex() {
    Vec3 position;
    position.x = coordinate();
    position.y = coordinate();
    position.z = coordinate();
    if (knownVertices() == std::numeric_limits<std::uint32_t>::max()) {
      fail(FOOTFALL_TEXT("more than 4294967295 vertices"), FOOTFALL_TEXT("split the file"));
    }
    environment_.vertices.push_back(position);
    skipStatement();
  }

  double coordinate() {
    skipBlanks();
    if (atEndOfValues()) {
      rejectTruncation();
      fail(FOOTFALL_TEXT("a vertex needs three coordinates"));
    }
    const char* start = cursor_;
    const char* digits = *start == '+' && start[1] != '-' ? start + 1 : start;
    double value = 0;
    const auto [stop, error] = std::from_chars(digits, end_, value);
    if (error == std::errc::invalid_argument || !(isBlank(*stop) || *stop == '\n' || *stop == '\0' || *stop == '\\')) {
      const bool comma = stop != digits && *stop == ',';
      fail(Text(FOOTFALL_TEXT("%1 is not a number"), word(start)),
           comma ? FOOTFALL_TEXT("write numbers with a decimal point, and export the file again") : kCorrectLine);
    }
    if (error == std::errc::result_out_of_range) value = outOfRange(digits, stop);
    if (!std::isfinite(value)) fail(Text(FOOTFALL_TEXT("coordinate %1 is not finite or too large"), word(start)));
    cursor_ = stop;
    return value;
  }

  /// from_chars reports numbers that are too small (these become zero) and too large by one error.
  static double outOfRange(const char* start, const char* stop) {
    std::istringstream stream(std::string(start, stop));
    stream.imbue(std::locale::classic());
    double value = 0;
    stream >> value;
    return stream.fail() ? std::numeric_limits<double>::infinity() : value;
  }

  template <class Vertices>
  void skip(const PendingPolygon& polygon, std::span<const std::uint32_t> corners, const Vertices& vertices) {
    SkippedPolygon skipped = skippedPolygon(corners, vertices);
    if (polygon.isFreeForm) skipped.reason = SkipReason::FreeForm;
    skipped.line = polygon.line;
    addSkipped(environment_.skipped, std::move(skipped));
  }

  void face() {
    const std::size_t line = line_;
    corners_.resize(faceStart_);
    for (skipBlanks(); !atEndOfValues(); skipBlanks()) corners_.push_back(cornerIndex());
    const std::size_t count = corners_.size() - faceStart_;
    if (count < 3) rejectTruncation();
    if (count == 3 && isTriangle()) {
      environment_.triangles.push_back({corners_[faceStart_], corners_[faceStart_ + 1], corners_[faceStart_ + 2]});
    } else {
      polygons_.push_back({environment_.triangles.size(), faceStart_, count, line});
      faceStart_ = corners_.size();
    }
    skipPhysicalLine();
  }

  /// Returns whether the three corners of the face are three vertices.
  [[nodiscard]] bool isTriangle() const {
    const std::uint32_t a = corners_[faceStart_], b = corners_[faceStart_ + 1], c = corners_[faceStart_ + 2];
    return a != b && b != c && c != a;
  }

  std::uint32_t cornerIndex() {
    const char* start = cursor_;
    const bool negative = *cursor_ == '-';
    if (negative) ++cursor_;
    if (!isDigit(*cursor_)) fail(Text(FOOTFALL_TEXT("%1 is not a face corner"), word(start)));
    std::uint64_t value = 0;
    for (; isDigit(*cursor_); ++cursor_) {
      if (value < std::uint64_t{1} << 40) value = value * 10 + static_cast<std::uint64_t>(*cursor_ - '0');
    }
    // Texture coordinate and normal indices are not used, but other characters in their place mean a broken file.
    while (*cursor_ == '/' || *cursor_ == '-' || isDigit(*cursor_)) ++cursor_;
    if (!isBlank(*cursor_) && !atLineEnd() && continuation() == 0)
      fail(Text(FOOTFALL_TEXT("%1 is not a face corner"), word(start)));

    const std::uint64_t known = knownVertices();
    if (value == 0) fail(FOOTFALL_TEXT("vertex index 0: OBJ counts from 1"));
    if (negative) {
      needWhole();
      if (value > known) {
        fail(Text(FOOTFALL_TEXT("vertex index %1 is out of range: only %2 before it"), word(start),
                  countedText(known, FOOTFALL_TEXT("1 vertex"), FOOTFALL_TEXT("%1 vertices"))));
      }
      return static_cast<std::uint32_t>(known - value);
    }
    if (value > std::numeric_limits<std::uint32_t>::max())
      fail(Text(FOOTFALL_TEXT("vertex index %1 is out of range"), word(start)));
    if (value > known && value > largestForward_) {
      largestForward_ = value;
      largestForwardLine_ = line_;
    }
    return static_cast<std::uint32_t>(value - 1);
  }

  void otherStatement() {
    const char* start = cursor_;
    while (isLetter(*cursor_)) ++cursor_;
    const std::string_view keyword(start, static_cast<std::size_t>(cursor_ - start));
    if (keyword == "v" || keyword == "f") {
      if (!atLineEnd() && continuation() == 0) fail(Text(FOOTFALL_TEXT("not an OBJ statement: %1"), word(start)));
      keyword == "v" ? vertex() : face();
      return;
    }
    if (keyword == "l") ++environment_.skipped.lines;
    if (groups_ != nullptr && keyword == "l") line();
    if (groups_ != nullptr && keyword == "g") group();
    if (keyword == "o") partName(ObjPartChanges::Object);
    if (keyword == "g") partName(ObjPartChanges::Group);
    if (keyword == "usemtl") partName(ObjPartChanges::Material);
    if (keyword == "p") {
      for (skipBlanks(); !atEndOfValues(); skipBlanks()) {
        ++environment_.skipped.points;
        while (!isBlank(*cursor_) && !atLineEnd() && continuation() == 0) ++cursor_;
      }
    }
    if (keyword == "surf") {
      corners_.resize(faceStart_);
      polygons_.push_back({environment_.triangles.size(), faceStart_, 0, line_, true});
    }
    if (keyword == "curv") ++environment_.skipped.lines;
    skipStatement();
  }

  void line() {
    std::optional<std::uint32_t> last;
    for (skipBlanks(); !atEndOfValues(); skipBlanks()) {
      const std::uint32_t corner = cornerIndex();
      if (last) groups_->segments.push_back({*last, corner});
      last = corner;
    }
  }

  void group() {
    skipBlanks();
    const char* stop = cursor_;
    while (*stop != '\n' && *stop != '\0' && *stop != '#') ++stop;
    while (stop > cursor_ && isBlank(stop[-1])) --stop;
    groups_->groups.push_back({std::string(cursor_, stop), environment_.triangles.size(), groups_->segments.size()});
    polygonsBefore_.push_back(polygons_.size());
  }

  /// The name extends to the end of the line, or to a comment behind a blank.
  void partName(ObjPartChanges::Kind kind) {
    skipBlanks();
    const char* stop = cursor_;
    while (*stop != '\n' && *stop != '\0' && !(*stop == '#' && isBlank(stop[-1]))) ++stop;
    while (stop > cursor_ && isBlank(stop[-1])) --stop;
    parts_.add(kind, {cursor_, static_cast<std::size_t>(stop - cursor_)}, environment_.triangles.size(),
               polygons_.size());
  }

  /// The groups counted triangular faces only; the first i polygons have added `added[i]` triangles.
  void moveGroups(const std::vector<std::size_t>& added) {
    if (groups_ == nullptr) return;
    for (std::size_t i = 0; i < groups_->groups.size(); ++i)
      groups_->groups[i].firstTriangle += added[polygonsBefore_[i]];
  }

  const std::string& path_;
  const char* begin_;
  const char* cursor_;
  const char* end_;
  Extent extent_;
  std::uint64_t verticesBefore_;
  Environment& environment_;
  RunContext* context_;
  ObjGroups* groups_;
  std::vector<std::size_t> polygonsBefore_;  ///< by group
  ObjPartChanges parts_;
  std::size_t line_;
  std::vector<std::uint32_t> corners_;  ///< corners of all pending polygons, then of the face being read
  std::size_t faceStart_ = 0;
  std::vector<PendingPolygon> polygons_;
  std::uint64_t largestForward_ = 0;
  std::size_t largestForwardLine_ = 0;
};

}  // namespace footfall::detail
