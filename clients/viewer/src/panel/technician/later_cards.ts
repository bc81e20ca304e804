// A bundle of its own, loaded when the server has what one of these cards shows.
import {type People, PeopleCard} from './people_card';
import {type RoomVoice, RoomVoiceCard} from './room_voice_card';

let people: PeopleCard | undefined;
let roomVoice: RoomVoiceCard | undefined;

/** Each shows its card; once is enough. */
export function showPeople(resource: People): void {
  people ??= new PeopleCard(resource);
}
export function showRoomVoice(resource: RoomVoice): void {
  roomVoice ??= new RoomVoiceCard(resource);
}
