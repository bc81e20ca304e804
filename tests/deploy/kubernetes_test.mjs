// The manifests of deploy/kubernetes: each object fits the schema of the Kubernetes API, and they belong together:
// kubernetes_test.mjs SOURCES.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';

const sources = process.argv[2];
const require = createRequire(`${sources}/tests/npm/package.json`);
const { parseAllDocuments } = require('yaml');
const models = {
  'apps/v1': () => require('kubernetes-models/apps/v1'),
  v1: () => require('kubernetes-models/v1'),
  'autoscaling/v2': () => require('kubernetes-models/autoscaling/v2'),
  'policy/v1': () => require('kubernetes-models/policy/v1'),
  'networking.k8s.io/v1': () => require('kubernetes-models/networking.k8s.io/v1'),
};
const documents = () =>
  parseAllDocuments(readFileSync(`${sources}/deploy/kubernetes/edge.yaml`, 'utf8')).map((document) => {
    assert.deepEqual(document.errors, []);
    return document.toJS();
  });
const modelOf = (object) => new (models[object.apiVersion]()[object.kind])(object);
const named = (kind) => documents().find((object) => object.kind === kind);

test('each object fits the schema of the Kubernetes API', () => {
  const objects = documents();
  assert.equal(objects.length, 6);
  for (const object of objects) modelOf(object).validate();
});

test('an object with a wrong field, type or value is found', () => {
  const spoil = (kind, change) => {
    const object = named(kind);
    change(object.spec);
    assert.throws(() => modelOf(object).validate(), kind);
  };
  spoil('Deployment', (spec) => (spec.template.spec.containers[0].ports[0].containerPort = 'many'));
  spoil('Deployment', (spec) => delete spec.selector);
  spoil('HorizontalPodAutoscaler', (spec) => delete spec.maxReplicas);
  spoil('Service', (spec) => (spec.ports = 7400));
});

test('the objects belong together', () => {
  const deployment = named('Deployment');
  const labels = deployment.spec.template.metadata.labels;
  const pod = deployment.spec.template.spec;
  const container = pod.containers[0];
  assert.deepEqual(named('Service').spec.selector, labels);
  assert.deepEqual(named('PodDisruptionBudget').spec.selector.matchLabels, labels);
  assert.deepEqual(named('NetworkPolicy').spec.podSelector.matchLabels, labels);
  assert.equal(named('HorizontalPodAutoscaler').spec.scaleTargetRef.name, deployment.metadata.name);
  const ports = container.ports.map((port) => port.name);
  for (const port of named('Service').spec.ports) assert.ok(ports.includes(port.targetPort), port.targetPort);
  const volumes = pod.volumes.map((volume) => volume.name);
  for (const mount of container.volumeMounts) assert.ok(volumes.includes(mount.name), mount.name);
  assert.equal(pod.volumes.find((volume) => volume.name === 'audit').persistentVolumeClaim.claimName,
    named('PersistentVolumeClaim').metadata.name);
});

test('the options of the edge are those of telepalp-server', () => {
  const source = readFileSync(`${sources}/server/command_line.cpp`, 'utf8');
  for (const word of named('Deployment').spec.template.spec.containers[0].args.filter((arg) => arg.startsWith('--')))
    assert.ok(source.includes(`"${word.slice(2)}"`), word);
});

test('the edges grow with what they send', () => {
  const { metric, target } = named('HorizontalPodAutoscaler').spec.metrics[0].pods;
  assert.equal(target.averageValue, '125M'); // bytes a second: 1 Gbit/s
  const page = readFileSync(`${sources}/docs/operations.md`, 'utf8');
  assert.ok(page.includes(`name: {as: ${metric.name}}`), 'the page has the rule of the metric');
});
