// ObjectTable: the objects of one System.  Adds, finds, ends and replaces them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/core/message.h"
#include "runtime/core/object.h"

namespace openr_host {

class System;

class ObjectTable {
 public:
  using Listener = std::function<void(ObjectId)>;
  // For each object that is replaced: the observers that are ready for its subjects.  The key is
  // the id of the object.
  using Readies = std::map<ObjectId, std::vector<StandingReady>>;

  // `system` must outlive the table.
  explicit ObjectTable(System* system) : system_(system) {}
  ~ObjectTable();
  ObjectTable(const ObjectTable&) = delete;
  ObjectTable& operator=(const ObjectTable&) = delete;

  // Adds `object`, whose id is a result of IdFor(), and returns it.  REQUIRES: no other object was
  // added with this id since the call of IdFor().
  Object* Adopt(std::unique_ptr<Object> object);
  // Returns the id for a new object of `robot`.  `key` is the path of the object, or its name if it
  // has no path.  If an object with this key existed before the robot was switched off, returns the
  // id of that object; otherwise returns a new id.
  ObjectId IdFor(int robot, std::string_view key) const;
  ObjectId NextId() const { return static_cast<ObjectId>(objects_.size()); }

  // Returns the object with this id; null if there is no such object.
  Object* Get(ObjectId id) const {
    const auto index = static_cast<size_t>(id);  // a negative `id` becomes a large number
    return index < objects_.size() ? objects_[index].get() : nullptr;
  }
  // Returns the object with this id.  REQUIRES: Get(id) has returned an object at any time before.
  // Objects are replaced but never removed, so there is still an object with this id.
  Object* GetKnown(ObjectId id) const { return objects_[static_cast<size_t>(id)].get(); }
  // Returns the object of `robot` with this name; null if there is no such object.  Leaves out
  // objects that are absent because the robot was switched off (Object::is_absent()).
  Object* Find(int robot, std::string_view name) const;
  const std::vector<std::unique_ptr<Object>>& all() const { return objects_; }

  // ---- Functions that end objects

  // Ends time events, network connections and registered names of object `id`, and deletes its
  // regions.  Must be called in a task (System::PostTask()), which runs only when no message is
  // due, because a message that is due may point into these regions.
  void EndAllOf(ObjectId id);
  // Registers `listener`, which EndAllOf() calls with the id of the object whose work it ends.  So
  // another part of the system can also end its work for the object.
  void OnEnd(Listener listener) { end_listeners_.push_back(std::move(listener)); }

  // Removes all objects of `robot`, which is off, except the object manager.  An absent object
  // (Object::is_absent()) takes the id and the statistics of each removed object.  REQUIRES: called
  // in a task.
  void RemoveAllOf(int robot);

  // Ends every connection of the other objects with object `id`.  A worker calls this when an
  // object of another process has been replaced.
  void DisconnectOthersFrom(ObjectId id);

  // ---- Functions that replace objects

  // Posts the replacement of an image by a new load of its file: DoStop and DoDestroy of the old
  // object, then DoInit, connections and DoStart of the new one.  The new object has the same OID,
  // static variables with their initial values, and an empty heap.  Messages to the old object are
  // lost, and regions that it had received go back to their subjects.  Data that it had sent still
  // arrive.  If the image cannot be loaded, an error finding is added and nothing changes.  The
  // constructors of the new image run before DoStop of the old object; what they send and register
  // takes effect when the new object is in place (early_work.h).
  // REQUIRES: System::booted(), and `id` names an image.
  void Reload(ObjectId id);

  // Posts the replacement of objects whose worker process was lost, that is, has ended or cannot be
  // reached.  EndAllOf() must have been called for these objects.  The new objects in `fresh` have
  // the same ids.  All of them are in place before the first DoInit.  REQUIRES: System::booted().
  void PostReplacement(std::vector<std::unique_ptr<Object>> fresh);

  // Registers a `listener` that is called with the id of every object that is replaced, before its
  // successor is in place.
  void OnReplace(Listener listener) { replace_listeners_.push_back(std::move(listener)); }

  // Puts the objects of `fresh` in place of the objects with the same ids.  Messages to the old
  // objects are lost.  Returns the observers that were ready for the old objects.  Called by
  // ObjectManager::ReplaceAndBoot() as one step of a replacement.
  Readies Replace(std::vector<std::unique_ptr<Object>> fresh);
  // Posts `readies`, which observers had sent to the object that was replaced, to the new object
  // `id` in the name of these observers.  The observers do not know of the replacement, so they
  // would not assert ready again themselves.  Called by ObjectManager::ReplaceAndBoot() as one step
  // of a replacement.
  void AssertAgain(ObjectId id, const std::vector<StandingReady>& readies);

 private:
  std::vector<StandingReady> EndMessagesTo(Object* old);
  std::vector<OwnedMessage> TakeMessagesTo(Object* object);
  void KeepSentRegions(ObjectId id);
  void Place(std::unique_ptr<Object> fresh);

  System* const system_;
  std::vector<std::unique_ptr<Object>> objects_;  // the index is the id of the object
  // Replaced objects whose handler waits or still has the processor.  They are kept, because that
  // handler needs its object until it ends.
  std::vector<std::unique_ptr<Object>> replaced_running_;
  std::vector<Listener> end_listeners_;
  std::vector<Listener> replace_listeners_;
};

}  // namespace openr_host
