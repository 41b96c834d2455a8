#include "uhas/model/dae_bounds_detail.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/model/xml_bounds_detail.hpp"

namespace uhas::detail {
namespace {

constexpr std::uint64_t max_nodes = 100'000;
constexpr int max_depth = 200;  // of nodes, those that are stood for included

constexpr std::string_view spaces = " \t\r\n";

std::string_view element(const XmlTag& tag) {
  const std::string_view rest = tag.text.substr(tag.closes() ? 2 : 1);
  return rest.substr(0, rest.find_first_of(" \t\r\n/>"));
}

// The value of an attribute; empty when there is none.
std::string_view attribute(const XmlTag& tag, std::string_view name) {
  std::size_t at = tag.text.find_first_of(spaces);
  while (at != std::string_view::npos) {
    const std::size_t key = tag.text.find_first_not_of(spaces, at);
    const std::size_t quote = tag.text.find_first_of("\"'", at);
    if (key == std::string_view::npos || quote == std::string_view::npos) break;
    const std::size_t end = tag.text.find(tag.text[quote], quote + 1);
    if (end == std::string_view::npos) break;
    const std::string_view found = tag.text.substr(key, tag.text.find_first_of(" \t\r\n=", key) - key);
    if (found == name) return tag.text.substr(quote + 1, end - quote - 1);
    at = end + 1;
  }
  return {};
}

class NodeCounter {
 public:
  NodeCounter(std::string_view text, const std::string& file) : file_(file) {
    for_each_tag(text, file, [this](const XmlTag& tag) { read(tag); });
  }

  void check() {
    if (has_references_ && has_instances_)  // names are compared as they are written
      throw Error(ErrorCode::invalid_mesh, file_,
                  "nodes stand for others, and the name of a node holds a character reference", "rename the node");
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].is_root) total += size(i, 0).nodes;
    if (total > max_nodes) refuse_count();
  }

 private:
  // Of a node with everything below.
  struct Size {
    std::uint64_t nodes = 0;  // 0: not yet known
    int depth = 0;
  };
  struct Node {
    bool is_root = true;
    std::vector<std::size_t> children;
    std::vector<std::string_view> instances;  // ids or names of other nodes
    Size size;
    bool being_counted = false;
  };
  // Nodes that share an id or a name.
  struct Namesakes {
    std::vector<std::size_t> nodes;
    Size largest;
  };

  void read(const XmlTag& tag) {
    const std::string_view name = element(tag);
    if (name == "library_nodes") in_library_ = !tag.closes() && !tag.is_empty();
    if (name == "node") tag.closes() ? close_node() : open_node(tag);
    if (name == "instance_node" && !open_.empty()) {
      const std::string_view url = attribute(tag, "url");
      if (url.starts_with('#')) nodes_[open_.back()].instances.push_back(url.substr(1));
      if (url.find('&') != std::string_view::npos) has_references_ = true;
      has_instances_ = true;
    }
  }

  void open_node(const XmlTag& tag) {
    const std::size_t index = nodes_.size();
    const std::string_view id = attribute(tag, "id"), name = attribute(tag, "name");
    nodes_.emplace_back().is_root = open_.empty();
    if (!open_.empty()) nodes_[open_.back()].children.push_back(index);
    if (open_.empty() && in_library_) library_[id] = index;
    by_name_[id].nodes.push_back(index);
    by_name_[name].nodes.push_back(index);
    if (id.find('&') != std::string_view::npos || name.find('&') != std::string_view::npos) has_references_ = true;
    if (!tag.is_empty()) open_.push_back(index);
  }

  void close_node() {
    if (!open_.empty()) open_.pop_back();
  }

  // Of what `name` may stand for, at most: assimp takes the node of the library first, else one of the scene by id or
  // name.
  Size size_named(std::string_view name, int depth) {
    if (const auto found = library_.find(name); found != library_.end()) return size(found->second, depth);
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return {};
    Namesakes& all = found->second;
    if (all.largest.nodes > 0) return all.largest;
    Size largest;
    for (const std::size_t index : all.nodes) {
      const Size one = size(index, depth);
      largest = {std::max(largest.nodes, one.nodes), std::max(largest.depth, one.depth)};
    }
    return all.largest = largest;
  }

  Size size(std::size_t index, int depth) {
    Node& node = nodes_[index];
    if (node.being_counted)
      throw Error(ErrorCode::invalid_mesh, file_, "a node stands for itself", "export the mesh again");
    if (node.size.nodes > 0) return node.size;
    node.being_counted = true;
    Size total{1, 0};
    const auto add = [&](Size below) {
      total = {total.nodes + below.nodes, std::max(total.depth, below.depth + 1)};
      if (total.nodes > max_nodes) refuse_count();
    };
    if (depth > max_depth) refuse_depth();
    for (const std::size_t child : node.children) add(size(child, depth + 1));
    for (const std::string_view name : node.instances) add(size_named(name, depth + 1));
    if (total.depth > max_depth) refuse_depth();
    node.being_counted = false;
    return node.size = total;
  }

  [[noreturn]] void refuse_depth() const {
    throw Error(ErrorCode::limit_exceeded, file_, "the nodes of the file are nested too deep", "export the mesh again");
  }
  [[noreturn]] void refuse_count() const {
    throw Error(
        ErrorCode::limit_exceeded, file_,
        "its scene comes to more than " + std::to_string(max_nodes) + " nodes, counted as often as they stand in it",
        "export the mesh again");
  }

  const std::string& file_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> open_;  // nodes whose end is still to come
  bool in_library_ = false, has_instances_ = false;
  bool has_references_ = false;  // &amp; or the like in a name
  std::map<std::string_view, std::size_t> library_;
  std::map<std::string_view, Namesakes> by_name_;
};

}  // namespace

void check_dae_nodes(std::string_view text, const std::string& file) { NodeCounter(text, file).check(); }

}  // namespace uhas::detail
