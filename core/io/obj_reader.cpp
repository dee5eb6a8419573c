// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/obj_reader.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>

#include "core/base/counted_text.hpp"
#include "core/base/parallel_ranges.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/io/input_file.hpp"
#include "core/io/obj_parts.hpp"
#include "core/io/polygon_triangulation.hpp"

namespace footfall::detail {
namespace {

constexpr Pattern kExportAgain = FOOTFALL_TEXT("correct the line or export the file again");

/// A face that is not a triangle; split, or left out, once all vertices are known, because a face may refer to later
/// ones.
struct PendingPolygon {
  std::size_t trianglesBefore;  ///< number of triangular faces before it in the file
  std::size_t firstCorner;
  std::size_t cornerCount;
  std::size_t line;
  bool isFreeForm = false;  ///< a curved surface, without corners
};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Thrown where a stretch of the text cannot be read without what comes before it.
struct NotAlone {};

/// One pass over the text, or over a stretch of whole lines of it. The text ends with a NUL and has no other, so that a
/// look at the current character is always allowed and never a statement at the end.
class ObjParser {
 public:
  enum class Extent { Whole, Stretch };

  ObjParser(const std::string& path, std::string_view text, Extent extent, Environment& environment,
            RunContext* context, ObjGroups* groups = nullptr)
      : path_(path),
        begin_(text.data()),
        cursor_(text.data()),
        end_(text.data() + text.size()),
        isStretch_(extent == Extent::Stretch),
        environment_(environment),
        context_(context),
        groups_(groups) {}

  /// The whole text.
  void parse() {
    parseStatements();
    checkForwardReferences();
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

  /// The largest vertex index that was used before so many vertices were known, or 0.
  [[nodiscard]] std::uint64_t largestForward() const { return largestForward_; }
  /// What names the parts; triangles are counted right after splitPolygons().
  [[nodiscard]] const ObjPartChanges& parts() const { return parts_; }

  /// Lines of this text once it has been read, when it ends with a line end.
  [[nodiscard]] std::size_t lineCount() const { return line_ - 1; }

  /// Puts the triangles of the polygons between those of the triangular faces, in the order of the file.
  void splitPolygons(const std::vector<Vec3>& vertices) {
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

  [[noreturn]] void fail(const Text& what, const Text& todo = kExportAgain) const {
    failInput(path_, line_, what, todo);
  }

  void needWhole() const {
    if (isStretch_) throw NotAlone{};
  }

  void poll() const {
    if (context_ == nullptr) return;
    context_->checkCancelled();
    if (!isStretch_) context_->progress(static_cast<double>(cursor_ - begin_) / static_cast<double>(end_ - begin_));
  }

  [[nodiscard]] bool atLineEnd() const { return *cursor_ == '\n' || *cursor_ == '\0'; }
  [[nodiscard]] bool atEndOfValues() const { return atLineEnd() || *cursor_ == '#'; }

  /// Length of "backslash, line end" here, or 0.
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

  /// To be called where a statement lacks something.
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
    if (environment_.vertices.size() == std::numeric_limits<std::uint32_t>::max()) {
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
           comma ? FOOTFALL_TEXT("write numbers with a decimal point, and export the file again") : kExportAgain);
    }
    if (error == std::errc::result_out_of_range) value = outOfRange(digits, stop);
    if (!std::isfinite(value)) fail(Text(FOOTFALL_TEXT("coordinate %1 is not finite or too large"), word(start)));
    cursor_ = stop;
    return value;
  }

  /// from_chars does not tell too small (a fine zero) from too large.
  static double outOfRange(const char* start, const char* stop) {
    std::istringstream stream(std::string(start, stop));
    stream.imbue(std::locale::classic());
    double value = 0;
    stream >> value;
    return stream.fail() ? std::numeric_limits<double>::infinity() : value;
  }

  void skip(const PendingPolygon& polygon, std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices) {
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

  /// Whether the three corners of the face are three vertices.
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
    // texture coordinate and normal indices are not used, but garbage in their place is a broken file
    while (*cursor_ == '/' || *cursor_ == '-' || isDigit(*cursor_)) ++cursor_;
    if (!isBlank(*cursor_) && !atLineEnd() && continuation() == 0)
      fail(Text(FOOTFALL_TEXT("%1 is not a face corner"), word(start)));

    const std::uint64_t known = environment_.vertices.size();
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

  void checkForwardReferences() const {
    if (largestForward_ <= environment_.vertices.size()) return;
    failInput(path_, largestForwardLine_,
              Text(FOOTFALL_TEXT("vertex index %1 is out of range: the file has %2"), largestForward_,
                   countedText(environment_.vertices.size(), FOOTFALL_TEXT("1 vertex"), FOOTFALL_TEXT("%1 vertices"))),
              kExportAgain);
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

  /// The name goes to the end of the line, or to a comment behind a blank.
  void partName(ObjPartChanges::Kind kind) {
    skipBlanks();
    const char* stop = cursor_;
    while (*stop != '\n' && *stop != '\0' && !(*stop == '#' && isBlank(stop[-1]))) ++stop;
    while (stop > cursor_ && isBlank(stop[-1])) --stop;
    parts_.add(kind, {cursor_, static_cast<std::size_t>(stop - cursor_)}, environment_.triangles.size(),
               polygons_.size());
  }

  /// The groups counted triangular faces only: `added[i]` triangles came of the first i polygons.
  void moveGroups(const std::vector<std::size_t>& added) {
    if (groups_ == nullptr) return;
    for (std::size_t i = 0; i < groups_->groups.size(); ++i)
      groups_->groups[i].firstTriangle += added[polygonsBefore_[i]];
  }

  const std::string& path_;
  const char* begin_;
  const char* cursor_;
  const char* end_;
  bool isStretch_;
  Environment& environment_;
  RunContext* context_;
  ObjGroups* groups_;
  std::vector<std::size_t> polygonsBefore_;  ///< for each group
  ObjPartChanges parts_;
  std::size_t line_ = 1;
  std::vector<std::uint32_t> corners_;  ///< corners of all pending polygons, then of the face being read
  std::size_t faceStart_ = 0;
  std::vector<PendingPolygon> polygons_;
  std::uint64_t largestForward_ = 0;
  std::size_t largestForwardLine_ = 0;
};

void rejectBinary(const std::string& path, const std::string& text) {
  const std::size_t nul = text.find('\0');
  if (nul == std::string::npos) return;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  failInput(path, static_cast<std::size_t>(line), FOOTFALL_TEXT("has a NUL byte, so it is not OBJ text"),
            FOOTFALL_TEXT("give the file the extension of its real format, or export it as plain text"));
}

constexpr std::size_t kStretchBytes = 1 << 17;

/// Whole lines each, the last one to the end of the text.
std::vector<std::string_view> cutIntoStretches(std::string_view text) {
  std::vector<std::string_view> stretches;
  while (text.size() > kStretchBytes) {
    const std::size_t end = text.find('\n', kStretchBytes);
    if (end == std::string_view::npos) break;
    stretches.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  if (!text.empty()) stretches.push_back(text);
  return stretches;
}

struct Stretch {
  Stretch(const std::string& path, std::string_view text, RunContext* context)
      : parser(path, text, ObjParser::Extent::Stretch, found, context) {
    found.vertices.reserve(text.size() / 64);
    found.triangles.reserve(text.size() / 64);
  }
  Environment found;
  ObjParser parser;
};

/// Reads stretches of the text on all threads. False, with nothing read, where that cannot be done or the text has an
/// error: one pass over the whole text then reads it, or tells the first error and its line.
bool readInStretches(const std::string& path, std::string_view text, Environment& environment, RunContext* context) {
  std::vector<std::unique_ptr<Stretch>> stretches;
  for (const std::string_view lines : cutIntoStretches(text))
    stretches.push_back(std::make_unique<Stretch>(path, lines, context));
  if (stretches.size() < 2) return false;
  std::atomic<bool> isReadable{true};
  std::atomic<std::size_t> done{0};
  forRanges(stretches.size(), 1, [&](std::size_t i, std::size_t) {
    if (!isReadable) return;
    try {
      stretches[i]->parser.parseStatements();
    } catch (const NotAlone&) {
      isReadable = false;
    } catch (const InputError&) {
      isReadable = false;
    }
    if (context == nullptr) return;
    context->checkCancelled();
    context->progress(static_cast<double>(done.fetch_add(1) + 1) / static_cast<double>(stretches.size()));
  });
  if (!isReadable) return false;
  std::size_t vertexCount = 0, triangleCount = 0;
  std::uint64_t largestForward = 0;
  for (const auto& stretch : stretches) {
    vertexCount += stretch->found.vertices.size();
    largestForward = std::max(largestForward, stretch->parser.largestForward());
  }
  if (largestForward > vertexCount || vertexCount > std::numeric_limits<std::uint32_t>::max()) return false;
  std::vector<Vec3>& vertices = environment.vertices;
  vertices.reserve(vertexCount);
  for (const auto& stretch : stretches)
    vertices.insert(vertices.end(), stretch->found.vertices.begin(), stretch->found.vertices.end());
  forRanges(stretches.size(), 1, [&](std::size_t i, std::size_t) { stretches[i]->parser.splitPolygons(vertices); });
  for (const auto& stretch : stretches) triangleCount += stretch->found.triangles.size();
  std::vector<Triangle>& triangles = environment.triangles;
  triangles.reserve(triangleCount);
  ObjPartAssigner parts(environment, triangleCount);
  std::uint64_t linesBefore = 0;
  for (const auto& stretch : stretches) {
    parts.add(stretch->parser.parts(), stretch->found.triangles.size());
    triangles.insert(triangles.end(), stretch->found.triangles.begin(), stretch->found.triangles.end());
    environment.skipped.points += stretch->found.skipped.points;
    environment.skipped.lines += stretch->found.skipped.lines;
    appendSkippedPolygons(environment.skipped, stretch->found.skipped, linesBefore);
    linesBefore += stretch->parser.lineCount();
  }
  parts.finish();
  return true;
}

}  // namespace

void readObj(const std::string& path, std::string text, Environment& environment, RunContext* context,
             ObjGroups* groups) {
  rejectBinary(path, text);
  // Files of old Macintosh programs end their lines with a lone carriage return.
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
  std::string_view statements(text);
  if (statements.substr(0, 3) == "\xEF\xBB\xBF") statements.remove_prefix(3);
  if (groups == nullptr && readInStretches(path, statements, environment, context)) return;
  ObjParser(path, statements, ObjParser::Extent::Whole, environment, context, groups).parse();
}

}  // namespace footfall::detail
