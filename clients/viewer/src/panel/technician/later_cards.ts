// A bundle of its own, loaded when the server has what one of these cards shows.
import {type People, PeopleCard} from './people_card';
import {type RoomVoice, RoomVoiceCard} from './room_voice_card';

let people: PeopleCard | undefined;
let roomVoice: RoomVoiceCard | undefined;

/** Shows the card, unless it is there; true: it has come now. */
export function showPeople(resource: People): boolean {
  const comes = people === undefined;
  people ??= new PeopleCard(resource);
  return comes;
}

/** As showPeople(). */
export function showRoomVoice(resource: RoomVoice): boolean {
  const comes = roomVoice === undefined;
  roomVoice ??= new RoomVoiceCard(resource);
  return comes;
}
