#include "haptic_station/scenes/solid_text.h"

#include <google/protobuf/descriptor.h>

#include "proto/words/counted.h"

namespace telepalp::scenes {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using solids::Node;
using solids::Op;
using solids::Solid;

std::size_t word_named(std::string_view text_name) {
  std::size_t index = 0;
  while (solids::words()[index].text_name != text_name) ++index;
  return index;
}

/// The end of a path that is too long for one line.
std::string shortened(const std::string& path) {
  constexpr std::size_t kShown = 60;
  if (path.size() <= kShown) return path;
  return "..." + path.substr(path.find('.', path.size() - kShown));
}

/// Walks the tree. Field names are the words' names, so one walk reads all kinds.
class TreeReader {
 public:
  TreeReader(const std::string& where, const solids::MeshReader& meshes, const WherePart& where_part)
      : where_(where), meshes_(meshes), where_part_(where_part) {}

  Result<void> read(const msg::Solid& message, const std::string& path, int level) {
    const FieldDescriptor* kind =
        message.GetReflection()->GetOneofFieldDescriptor(message, message.GetDescriptor()->oneof_decl(0));
    if (kind == nullptr)
      return error(message, path, "the solid has no kind", "name its kind, as in of { sphere { radius_m: 0.02 } }");
    if (level > solids::kMostNesting)
      return error(message, path, "operators nest deeper than " + std::to_string(solids::kMostNesting) + " levels",
                   "put more than two solids into one union instead of nesting unions");
    const Message& body = message.GetReflection()->GetMessage(message, kind);
    Node node{.word = word_named(kind->name())};
    const std::string here = path + (path.empty() ? "" : ".") + kind->name();
    if (const Result<void> done = read_numbers(body, node, here); !done) return done.error();
    if (const Result<void> done = read_mesh(body, node, here); !done) return done.error();
    return read_operands(body, node, here, level);
  }
  [[nodiscard]] Solid& solid() { return solid_; }

 private:
  [[nodiscard]] Error error(const Message& part, const std::string& path, const std::string& what,
                            std::string fix) const {
    return {.what = (path.empty() ? "" : shortened(path) + ": ") + what,
            .where = where_part_ ? where_part_(part, "", 0.0) : where_,
            .fix = std::move(fix)};
  }

  Result<void> read_numbers(const Message& body, Node& node, const std::string& path) {
    for (std::size_t i = 0; i < node.kind().numbers.size(); ++i) {
      const std::string name(node.kind().numbers[i].name);
      const FieldDescriptor* field = body.GetDescriptor()->FindFieldByName(name);
      if (!body.GetReflection()->HasField(body, field)) return error(body, path, name + " is missing", "give " + name);
      node.numbers[i] = body.GetReflection()->GetDouble(body, field);
    }
    const auto complaint = solids::complaint_about(node);
    if (!complaint) return {};
    Error about = error(body, path, complaint->what, complaint->fix);
    if (where_part_)
      about.where = where_part_(body, node.kind().numbers[complaint->number].name, node.numbers[complaint->number]);
    return about;
  }

  Result<void> read_mesh(const Message& body, Node& node, const std::string& path) {
    if (node.kind().op != Op::Mesh) return {};
    const auto& mesh = static_cast<const msg::Solid::Mesh&>(body);
    node.file = mesh.file();
    if (node.file.empty() || node.file.find_first_of(" \t\n#") != std::string::npos)
      return error(body, path, "the field 'file' is empty, or names a file with a space or # in its path",
                   "name a closed mesh, .ply or .obj, by a path without spaces and #");
    auto lattice = meshes_(node.file, node.numbers[0], node.numbers[1]);
    if (!lattice) return error(body, path, lattice.error().where + ": " + lattice.error().what, lattice.error().fix);
    node.lattice = std::move(lattice).value();
    return {};
  }

  Result<void> read_operands(const Message& body, const Node& node, const std::string& path, int level) {
    const int wanted = node.kind().operands;
    if (wanted == 0) {
      solid_.push_back(node);
      return {};
    }
    const FieldDescriptor* field = body.GetDescriptor()->FindFieldByName("of");
    const int count = body.GetReflection()->FieldSize(body, field);
    const bool chain = node.kind().op == Op::Union;
    if (count < wanted || (count > wanted && !chain))
      return error(body, path,
                   "has " + counted(count, "operand", "operands") + " instead of " + std::to_string(wanted) +
                       (chain ? " or more" : ""),
                   "give each operand as of { ... }");
    for (int i = 0; i < count; ++i) {
      const bool opens = chain ? i + 1 < count : i == 0;
      if (opens) solid_.push_back(node);
      const auto& operand = static_cast<const msg::Solid&>(body.GetReflection()->GetRepeatedMessage(body, field, i));
      const Result<void> done = read(operand, path + ".of[" + std::to_string(i) + "]", level + 1);
      if (!done) return done.error();
    }
    return {};
  }

  const std::string& where_;
  const solids::MeshReader& meshes_;
  const WherePart& where_part_;
  Solid solid_;
};

/// Writes the solid that starts at node `at`, and returns one past its last node.
std::size_t write(const Solid& solid, std::size_t at, msg::Solid& message) {
  const Node& node = solid[at];
  const FieldDescriptor* kind = message.GetDescriptor()->FindFieldByName(std::string(node.kind().text_name));
  Message& body = *message.GetReflection()->MutableMessage(&message, kind);
  const Reflection& reflection = *body.GetReflection();
  for (std::size_t i = 0; i < node.kind().numbers.size(); ++i)
    reflection.SetDouble(&body, body.GetDescriptor()->FindFieldByName(std::string(node.kind().numbers[i].name)),
                         node.numbers[i]);
  if (node.kind().op == Op::Mesh) static_cast<msg::Solid::Mesh&>(body).set_file(node.file);
  ++at;
  const FieldDescriptor* of = body.GetDescriptor()->FindFieldByName("of");
  for (int missing = node.kind().operands; missing > 0; --missing) {
    const bool last = missing == 1;
    if (last && node.kind().op == Op::Union && solid[at].kind().op == Op::Union) {
      ++at;  // the chain goes on: its next union adds an operand to this one
      missing = 3;
      continue;
    }
    at = write(solid, at, static_cast<msg::Solid&>(*reflection.AddMessage(&body, of)));
  }
  return at;
}

}  // namespace

Result<Solid> solid_of(const msg::Solid& message, const std::string& where, const solids::MeshReader& meshes,
                       const WherePart& where_part) {
  TreeReader reader(where, meshes, where_part);
  if (const Result<void> done = reader.read(message, "", 0); !done) return done.error();
  return std::move(reader.solid());
}

msg::Solid message_of(const Solid& solid) {
  msg::Solid message;
  (void)write(solid, 0, message);
  return message;
}

}  // namespace telepalp::scenes
