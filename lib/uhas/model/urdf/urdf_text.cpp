#include "uhas/model/urdf/urdf_text.hpp"

#include <tinyxml.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "uhas/base/errors.hpp"
#include "uhas/model/urdf/link_order.hpp"
#include "uhas/model/urdf/xml_bounds.hpp"

namespace uhas {
namespace {

template <class Predicate>
void remove_children(TiXmlElement& parent, Predicate unwanted) {
  for (TiXmlNode *child = parent.FirstChild(), *next = nullptr; child != nullptr; child = next) {
    next = child->NextSibling();
    if (unwanted(*child)) parent.RemoveChild(child);
  }
}

template <std::size_t N>
auto none_of(const std::array<std::string_view, N>& tags) {
  return [&tags](const TiXmlNode& node) {
    return node.ToElement() == nullptr || std::ranges::find(tags, node.ValueStr()) == tags.end();
  };
}

TiXmlElement* shape_of(TiXmlElement& visual_or_collision) {
  TiXmlElement* geometry = visual_or_collision.FirstChildElement("geometry");
  return geometry != nullptr ? geometry->FirstChildElement() : nullptr;
}

void reduce_link(TiXmlElement& link) {
  static constexpr std::array<std::string_view, 2> shapes{"visual", "collision"};
  static constexpr std::array<std::string_view, 2> parts{"origin", "geometry"};
  remove_children(link, none_of(shapes));
  remove_children(link, [](TiXmlNode& node) { return shape_of(*node.ToElement()) == nullptr; });
  for (TiXmlElement* element = link.FirstChildElement(); element != nullptr; element = element->NextSiblingElement()) {
    remove_children(*element, none_of(parts));
    TiXmlElement& shape = *shape_of(*element);
    element->SetAttribute("name", shape.Value());
    if (shape.ValueStr() == "capsule") shape.SetValue("cylinder");
  }
}

void reduce_joint(TiXmlElement& joint) {
  static constexpr std::array<std::string_view, 6> parts{"origin", "parent", "child", "axis", "limit", "mimic"};
  remove_children(joint, none_of(parts));
  if (TiXmlElement* limit = joint.FirstChildElement("limit")) {
    // urdfdom refuses a limit without these two, which many hands leave out
    for (const char* optional : {"effort", "velocity"})
      if (limit->Attribute(optional) == nullptr) limit->SetAttribute(optional, "0");
  }
}

std::string name_of(const TiXmlElement& element, const std::string& file) {
  const char* name = element.Attribute("name");
  if (name == nullptr || *name == '\0')
    throw Error(ErrorCode::invalid_model, file + ":" + std::to_string(element.Row()),
                "a " + element.ValueStr() + " has no name", "give it one");
  return name;
}

/// The `link` attribute of a joint's parent or child; empty when there is none.
std::string link_of(const TiXmlElement& joint, const char* end) {
  const TiXmlElement* element = joint.FirstChildElement(end);
  const char* link = element != nullptr ? element->Attribute("link") : nullptr;
  return link != nullptr ? link : "";
}

/// urdfdom frees a chain of links by recursion, so a chain as long as the file allows must not reach it.
void check_link_count(const TiXmlElement& robot, const std::string& file, std::uint64_t max_links) {
  std::uint64_t links = 0;
  for (const TiXmlElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link"))
    ++links;
  if (links > max_links)
    throw Error(ErrorCode::limit_exceeded, file,
                "has " + std::to_string(links) + " links, more than the bound of " + std::to_string(max_links),
                "cut the hand out of its robot or raise ModelLoadOptions::max_links");
}

/// urdfdom keeps graphs with a cycle in memory for ever and tells little of the others it refuses, so a graph that is
/// no tree must not reach it.
void check_tree(const TiXmlElement& robot, const std::string& file) {
  Urdf skeleton;
  for (const TiXmlElement* child = robot.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    if (child->ValueStr() == "link") {
      skeleton.links.push_back({name_of(*child, file), {}, {}});
    } else {
      UrdfJoint& joint = skeleton.joints.emplace_back();
      joint.joint.name = name_of(*child, file);
      joint.parent_link = link_of(*child, "parent");
      joint.child_link = link_of(*child, "child");
    }
  }
  const auto link_name = [](const UrdfLink& link) -> const std::string& { return link.name; };
  const auto joint_name = [](const UrdfJoint& joint) -> const std::string& { return joint.joint.name; };
  const auto sort_unique = [&file](auto& list, auto name, const std::string& kind) {
    std::ranges::sort(list, {}, name);
    const auto twin = std::ranges::adjacent_find(list, {}, name);
    if (twin != list.end())
      throw Error(ErrorCode::invalid_model, file, "two " + kind + " have the name '" + name(*twin) + "'", "rename one");
  };
  sort_unique(skeleton.links, link_name, "links");
  sort_unique(skeleton.joints, joint_name, "joints");
  if (skeleton.links.empty())
    throw Error(ErrorCode::invalid_model, file, "the URDF has no link", "name the URDF of a hand");
  order_links(skeleton, file);
}

}  // namespace

std::string reduce_urdf(const std::string& text, const std::string& file, std::uint64_t max_links) {
  if (text.find('\0') != std::string::npos)
    throw Error(ErrorCode::syntax, file, "the file holds a zero byte, so it is not XML", "name a URDF file");
  check_xml_bounds(text, file);

  TiXmlDocument document;
  document.Parse(text.c_str());
  const std::string place = document.ErrorRow() > 0 ? file + ":" + std::to_string(document.ErrorRow()) : file;
  if (document.Error())
    throw Error(ErrorCode::syntax, place, std::string("this is not well-formed XML (") + document.ErrorDesc() + ")",
                "correct the file");
  TiXmlElement* robot = document.RootElement();
  if (robot == nullptr) throw Error(ErrorCode::syntax, file, "the file has no XML element", "name a URDF file");
  if (robot->ValueStr() != "robot")
    throw Error(ErrorCode::syntax, file,
                "this is not a URDF: the root element is <" + robot->ValueStr() + ">, not <robot>", "name a URDF file");
  for (const TiXmlElement* child = robot->FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    if (child->ValueStr().starts_with("xacro:"))
      throw Error(ErrorCode::syntax, file + ":" + std::to_string(child->Row()),
                  "the file holds <" + child->ValueStr() + ">, so it is xacro that was not expanded",
                  "expand it first: xacro " + file + " > hand.urdf");

  static constexpr std::array<std::string_view, 2> parts{"link", "joint"};
  remove_children(*robot, none_of(parts));
  for (TiXmlElement* child = robot->FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    child->ValueStr() == "link" ? reduce_link(*child) : reduce_joint(*child);

  check_link_count(*robot, file, max_links);
  check_tree(*robot, file);

  TiXmlPrinter printer;
  robot->Accept(&printer);
  return printer.Str();
}

}  // namespace uhas
