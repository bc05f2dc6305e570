#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"

/// Edits of a document as functions from values to values: each result is one step of undo.
namespace blossom {

class Registry;
struct FeatureType;

/// Everything that is made from one of `ids`, directly or not, without those themselves; in document order.
std::vector<FeatureId> dependants(const Document&, const std::vector<FeatureId>& ids);

Document withVisible(Document, const std::vector<FeatureId>& ids, bool visible);
Document withSuppressed(Document, const std::vector<FeatureId>& ids, bool suppressed);

/// Users go before what they use. @throws Error InUse when one of them is used by a feature that stays.
Document withoutAll(Document, const std::vector<FeatureId>& ids);

/// The same where each of `ids` is made from one shape, which users take instead; nothing where one does so already.
std::optional<Document> withoutSteps(Document, const std::vector<FeatureId>& ids);

/// Only `ids` are visible.
Document withOnlyVisible(Document, const std::vector<FeatureId>& ids);
bool areOnlyVisible(const Document&, const std::vector<FeatureId>& ids);

/// `ids` stand one after the other, in document order, before what is in row `row` now; row == size: at the end.
/// @throws Error InvalidInput when one would stand before an input or after a user of its own.
Document withMoved(const Document&, const std::vector<FeatureId>& ids, std::size_t row);
/// `ids` one place up (-1) or down (+1). @throws as withMoved; nullopt when they stand at that end already.
std::optional<Document> withStepped(const Document&, const std::vector<FeatureId>& ids, int by);

/// An edit and the one before it (-1) or after it (+1) the other way round, where one follows the other, nothing else is
/// made from the first, and both are edits of one kind of shape (InputUse::Edited), such as pulls of a motion. Who uses the
/// second goes on from what is the second then. Nothing where that is not so.
std::optional<Document> withEditsExchanged(const Registry&, const Document&, const FeatureId&, int by);

/// "Box", or "Box 2" when there is one; a number that `name` ends in is counted on. O(n log n) in the features.
std::string freeName(const Document&, const std::string& name);

/// A feature as it is added to a document, with an id and a name that no other one has there: the title of its type, counted
/// on. All features begin so, whoever adds them.
Feature newFeature(const Document&, const FeatureType&, std::vector<FeatureId> inputs = {});

/// `wanted` of `clip` added to a document as new features with ids and names of their own; `added` is what they are called
/// there. What they are made from is taken over too, unless `into` holds just that feature already.
Document withCopies(const Document& into, const Document& clip, const std::vector<FeatureId>& wanted,
                    std::vector<FeatureId>& added);
/// The part of a document that `wanted` needs: these, and everything they are made from.
Document excerpt(const Document&, const std::vector<FeatureId>& wanted);

/// `into` with the features of `other` added that `wanted` needs, itself included, under free ids made from the commands of
/// their types and free names; `added` is the id of `wanted` there. Files that `other` may not read are not read there
/// either.
/// @throws Error NotFound.
Document withFeatureOf(const Registry&, const Document& into, const Document& other, const FeatureId& wanted,
                       FeatureId* added);

/// The feature that a document makes: its last one that is not suppressed. @throws Error InvalidInput when there is none.
const Feature& lastFeature(const Document&);

/// `edit`, which takes one shape, added between that and some of its users, which take what it makes instead.
/// @throws Error as Document::with.
Document withInserted(Document, const Feature& edit, const std::vector<FeatureId>& users);
/// The users that go on with an edit of a feature that is made now: all but those to which it is a step of the way (see
/// InputUse::Step).
std::vector<FeatureId> usersOfEdited(const Registry&, const Document&, const FeatureId&);

// These read files; embedded_files.cpp.

/// The content of every file that a feature names by its path is taken into the document as an asset, so that the document
/// can be moved away from its files; of the path the name of the file is kept. Files that the document may not read stay
/// named and are not read. @throws Error FileNotFound, FileUnreadable, LimitExceeded.
Document withFilesEmbedded(const Registry&, const Document&);
/// The same, but files that are not there stay named, too.
Document withFoundFilesEmbedded(const Registry&, const Document&);

/// The files outside of its folder that the document names and may not read.
std::vector<std::filesystem::path> withheldFiles(const Registry&, const Document&);

}  // namespace blossom
