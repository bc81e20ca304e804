import type {ChangedStates, Published, StateTopic, StateTopics} from '../messages/topics';
import {askServer} from './ask_server';
import {Resource, type Traits} from './resource';

type Take<Message> = (newest: Published<Message> | undefined) => void;

/** What the page knows of the server's resources. */
export class ServerResources {
  private readonly takers = new Map<StateTopic, Take<unknown>>();
  private readonly commanded = new Map<StateTopic, Resource<never, unknown, never>>();

  /** `take` gets each state of a resource, to show it alone. */
  on<Topic extends StateTopic>(topic: Topic, take: Take<StateTopics[Topic]>): void {
    this.takers.set(topic, take as Take<unknown>);
  }

  /** A resource that the page changes. It has no state for a visitor who may not change it. */
  at<Topic extends StateTopic, State, Command extends object>(
      topic: Topic, traits: Traits<StateTopics[Topic], State, Command>): Resource<StateTopics[Topic], State, Command> {
    const resource = new Resource<StateTopics[Topic], State, Command>(askServer(topic), traits);
    this.commanded.set(topic, resource as unknown as Resource<never, unknown, never>);
    return resource;
  }

  /** `may`: the paths of the resources that this visitor may change. */
  changed(states: ChangedStates, may: readonly string[]): void {
    for (const topic of Object.keys(states) as StateTopic[]) {
      this.takers.get(topic)?.(states[topic]);
      this.commanded.get(topic)?.take(may.includes(topic) ? states[topic] as Published<never> | undefined : undefined);
    }
  }

  connected(is: boolean): void {
    for (const resource of this.commanded.values()) resource.connected(is);
  }
}
