#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/architecture/page_imports.h"
#include "where.h"

namespace telepalp::architecture {
namespace {

const std::filesystem::path kViewer = TELEPALP_SOURCE_DIR "/clients/viewer";

PageRooms the_rooms() { return read_page_rooms(kViewer / "rooms.txt"); }
PageImports the_imports() { return read_page_imports(kViewer / "src"); }

TEST(PageRooms, ImportOnlyWhatTheirLinesName) {
  const PageRooms rooms = the_rooms();
  const PageImports imports = the_imports();
  ASSERT_GE(rooms.rooms.size(), 10U);
  ASSERT_GE(imports.size(), 100U);
  for (const std::string& sentence : page_violations(rooms, imports)) ADD_FAILURE() << sentence;
  std::cout << rooms.rooms.size() << " rooms, " << imports.size() << " files\n";
}

/// A defect that somebody could commit, and the sentence that must name it.
struct PlantedImport {
  const char* law;
  std::function<void(PageRooms&, PageImports&)> plant;
  std::string sentence;
};

Allowed& room_named(PageRooms& rooms, const std::string& name) {
  return *std::find_if(rooms.rooms.begin(), rooms.rooms.end(), [&](const Allowed& room) { return room.name == name; });
}

const std::vector<PlantedImport> kPlantedImports{
    {"no room imports one above it",
     [](PageRooms&, PageImports& imports) {
       imports["link/stream"].push_back({"panel/banner_look", false, true});
     },
     "link may not import panel"},
    {"the list itself points one way",
     [](PageRooms& rooms, PageImports& imports) {
       room_named(rooms, "link").rooms.push_back("panel");
       imports["link/stream"].push_back({"panel/banner_look", false, true});
     },
     "link names panel, which does not stand above it"},
    {"no circle within a room",
     [](PageRooms&, PageImports& imports) {
       imports["page/page"].push_back({"page/rows", false, true});
     },
     "a circle: page/page -> page/rows -> page/page"},
    {"each folder is a room", [](PageRooms&, PageImports& imports) { imports["odds/ends"] = {}; },
     "odds/ends is in no room of the list"},
    {"a room imports no other package",
     [](PageRooms&, PageImports& imports) {
       imports["present/instants"].push_back({"three", true, true});
     },
     "present may not import three"},
    {"a line names nothing more than is imported",
     [](PageRooms& rooms, PageImports&) { room_named(rooms, "scene").rooms.push_back("words"); },
     "scene imports nothing of words, which its line names"},
    {"a worker runs no code of the page",
     [](PageRooms&, PageImports& imports) {
       imports["inside/probe_images"].push_back({"page/page", false, false});
     },
     "the worker site/link_worker.ts may not import page"},
};

/// Plants each defect in a copy of the true imports. The check must then find this defect and no other.
TEST(PageRooms, EachPlantedViolationIsFoundAlone) {
  for (const PlantedImport& planted : kPlantedImports) {
    PageRooms rooms = the_rooms();
    PageImports imports = the_imports();
    planted.plant(rooms, imports);
    EXPECT_EQ(page_violations(rooms, imports), std::vector<std::string>{planted.sentence}) << planted.law;
    std::cout << planted.law << ": " << planted.sentence << "\n";
  }
}

TEST(PageRooms, EveryKindOfImportIsRead) {
  const auto words = [](const std::string& text) {
    std::string all;
    for (const PageImport& one : imports_in(text, "panel/qa/notes_card"))
      all += one.name + (one.is_package ? " package" : "") + (one.is_type_only ? " type" : "") + "\n";
    return all;
  };
  EXPECT_EQ(words("import {a} from '../../page/page';"), "page/page\n");
  EXPECT_EQ(words("// a comment\nimport {\n  type A,\n  b,\n} from '../banner';"), "panel/banner\n");
  EXPECT_EQ(words("import {\n  type A, type B,\n} from '../banner';"), "panel/banner type\n");
  EXPECT_EQ(words("import type * as a from './notes_card';"), "panel/qa/notes_card type\n");
  EXPECT_EQ(words("export {EventKind} from \"../../messages/messages\";"), "messages/messages\n");
  EXPECT_EQ(words("import './style';\nimport x from '@bufbuild/protobuf/wkt';"),
            "@bufbuild/protobuf package\npanel/qa/style\n");
  EXPECT_EQ(words("const late = await import('../voice');"), "panel/voice\n");
  EXPECT_EQ(words("const says = 'an import from \\'three\\'';"), "");
}

std::string cell_of(const Allowed& room) {
  std::string cell;
  const auto add = [&](const std::string& word) { cell += (cell.empty() ? "" : ", ") + word; };
  for (const std::string& one : room.rooms) add("`" + one + "`");
  for (const std::string& one : room.packages) add(one);
  return cell.empty() ? "| |" : "| " + cell + " |";
}

TEST(PageRooms, AreTheRowsOfTheDocumentInTheSameOrder) {
  std::ifstream document(TELEPALP_SOURCE_DIR "/docs/architecture.md");
  std::vector<std::string> rows;
  for (std::string line; std::getline(document, line) && !line.starts_with("The station's rooms");) {
    if (line.starts_with("The web viewer's rooms")) rows.clear();
    if (line.starts_with("| `")) rows.push_back(line);
  }
  const PageRooms rooms = the_rooms();
  ASSERT_EQ(rows.size(), rooms.rooms.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_TRUE(rows[i].starts_with("| `" + rooms.rooms[i].name + "` |")) << rows[i];
    EXPECT_TRUE(rows[i].ends_with(cell_of(rooms.rooms[i])))
        << rows[i] << "\nshould end with " << cell_of(rooms.rooms[i]);
  }
}

}  // namespace
}  // namespace telepalp::architecture
